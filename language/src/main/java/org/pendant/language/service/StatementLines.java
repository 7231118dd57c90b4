package org.pendant.language.service;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;

/** Statement lines: lines with statements that run, where a debugger can stop. */
final class StatementLines {
  private final Source source;
  private final SortedSet<Integer> lines = new TreeSet<>();
  private final List<SourceRange> statements = new ArrayList<>();

  private StatementLines(Script script) {
    source = script.source();
    visit(script.statements());
  }

  static StatementLines of(Script script) {
    return new StatementLines(script);
  }

  /** The 1-based lines on which a statement or a condition begins. */
  SortedSet<Integer> lines() {
    return Collections.unmodifiableSortedSet(lines);
  }

  /** The smallest statement that covers a part of {@code line}. */
  Optional<SourceRange> enclosing(int line) {
    Optional<SourceRange> best = Optional.empty();
    for (SourceRange range : statements) {
      boolean covers =
          source.line(range.start()) <= line
              && source.line(Math.max(range.start(), range.end() - 1)) >= line;
      boolean smaller =
          best.isEmpty() || range.end() - range.start() < best.get().end() - best.get().start();
      if (covers && smaller) {
        best = Optional.of(range);
      }
    }
    return best;
  }

  private void visit(List<Statement> all) {
    for (Statement statement : all) {
      visit(statement);
    }
  }

  private void visit(Statement statement) {
    statements.add(statement.range());
    switch (statement) {
      case Statement.If choice -> {
        for (Statement.Branch branch : choice.branches()) {
          stopAt(branch.range().start());
          visit(branch.body());
        }
        choice.otherwise().ifPresent(this::visit);
      }
      case Statement.While loop -> {
        stopAt(loop.range().start());
        visit(loop.body());
      }
      case Statement.Definition definition -> visit(definition.body());
      case Statement.Label _ -> {}
      case Statement.Assign _,
          Statement.Evaluate _,
          Statement.Break _,
          Statement.Continue _,
          Statement.Halt _,
          Statement.Pause _,
          Statement.Return _,
          Statement.Join _,
          Statement.Kill _,
          Statement.EnterCritical _,
          Statement.ExitCritical _ ->
          stopAt(statement.range().start());
    }
  }

  private void stopAt(int offset) {
    lines.add(source.line(offset));
  }
}
