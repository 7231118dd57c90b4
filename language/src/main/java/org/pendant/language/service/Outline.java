package org.pendant.language.service;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.pendant.language.service.Occurrence.Role;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Statement.Definition;

/** Outline builder: definitions inside each other, and globals where they are first assigned. */
final class Outline {
  private final Signatures signatures;
  private final List<Definition> definitions;
  private final List<Occurrence> globals;

  private Outline(ScriptAnalysis analysis) {
    signatures = analysis.signatures();
    definitions =
        analysis.scopes().definitions().stream()
            .sorted(Comparator.comparingInt(definition -> definition.range().start()))
            .toList();
    globals = firstAssignments(analysis.index());
  }

  static List<OutlineItem> of(ScriptAnalysis analysis) {
    int end = analysis.source().text().length();
    return List.copyOf(new Outline(analysis).inside(new SourceRange(0, end), -1));
  }

  /** What stands directly inside {@code range}, the range of the definition at {@code outer}. */
  private List<OutlineItem> inside(SourceRange range, int outer) {
    List<OutlineItem> items = new ArrayList<>();
    int covered = -1;
    List<SourceRange> inner = new ArrayList<>();
    for (int i = outer + 1; i < definitions.size(); i++) {
      Definition definition = definitions.get(i);
      if (definition.range().start() >= range.end()) {
        break;
      }
      if (definition.range().start() >= covered) {
        covered = definition.range().end();
        inner.add(definition.range());
        items.add(item(definition, i));
      }
    }
    for (Occurrence global : globals) {
      if (contains(range, global) && inner.stream().noneMatch(other -> contains(other, global))) {
        items.add(
            new OutlineItem(
                OutlineItem.Kind.GLOBAL,
                global.symbol().name(),
                "",
                global.range(),
                global.range(),
                List.of()));
      }
    }
    items.sort(Comparator.comparingInt(item -> item.range().start()));
    return items;
  }

  private OutlineItem item(Definition definition, int index) {
    String head = signatures.of(definition).head();
    return new OutlineItem(
        switch (definition.kind()) {
          case FUNCTION -> OutlineItem.Kind.FUNCTION;
          case SECONDARY -> OutlineItem.Kind.SECONDARY;
          case THREAD -> OutlineItem.Kind.THREAD;
        },
        definition.name(),
        head.substring(definition.name().length()),
        definition.range(),
        definition.nameRange(),
        inside(definition.range(), index));
  }

  private static boolean contains(SourceRange range, Occurrence global) {
    return range.start() <= global.range().start() && global.range().end() <= range.end();
  }

  private static List<Occurrence> firstAssignments(SymbolIndex index) {
    Set<Symbol> seen = new HashSet<>();
    return index.all().stream()
        .filter(occurrence -> occurrence.symbol() instanceof Symbol.Global)
        .filter(occurrence -> occurrence.role() == Role.WRITE)
        .filter(occurrence -> seen.add(occurrence.symbol()))
        .toList();
  }
}
