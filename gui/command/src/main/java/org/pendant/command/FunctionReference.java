package org.pendant.command;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.testing.builtin.TestBuiltins;

/**
 * The reference of all built-in functions and methods, made from the catalogue: as a table and
 * single entries for the terminal, and as the Markdown of docs/functions.md.
 */
final class FunctionReference {
  /** Names of functions that are longer than this push their sentence aside. */
  private static final int NAME_COLUMNS = 34;

  private final Map<String, List<Signature>> byModule;
  private final boolean ofTests;

  /** The reference of what programs may call. */
  FunctionReference(Catalogue catalogue) {
    this(catalogue.all(), false);
  }

  private FunctionReference(Collection<Signature> signatures, boolean ofTests) {
    this.ofTests = ofTests;
    byModule = new LinkedHashMap<>();
    for (Signature signature : signatures) {
      byModule.computeIfAbsent(group(signature), key -> new ArrayList<>()).add(signature);
    }
    byModule.values().forEach(list -> list.sort(Comparator.comparing(Signature::name)));
  }

  /** The reference of what tests alone may call. */
  static FunctionReference ofTests(Catalogue catalogue) {
    return new FunctionReference(
        catalogue.all().stream()
            .filter(each -> each.module().equals(TestBuiltins.MODULE))
            .filter(each -> !TestBuiltins.isHidden(each.name()))
            .toList(),
        true);
  }

  /**
   * Functions stand under their module, methods under what they are called on, and functions of
   * tests under what they are about.
   */
  private static String group(Signature signature) {
    if (signature.module().equals(TestBuiltins.MODULE)) {
      return signature.section();
    }
    return signature
        .receiver()
        .map(type -> "Methods of a " + type.text())
        .orElse("Module " + signature.module());
  }

  /** Every name that {@link #entries} knows. */
  List<String> names() {
    return all().stream().map(Signature::name).distinct().toList();
  }

  private Collection<Signature> all() {
    return byModule.values().stream().flatMap(List::stream).toList();
  }

  /** One line for each function: its head and what it does. */
  List<String> table() {
    List<String> lines = new ArrayList<>();
    byModule.forEach(
        (module, signatures) -> {
          if (!lines.isEmpty()) {
            lines.add("");
          }
          lines.add(module);
          for (Signature signature : signatures) {
            String head = call(signature);
            if (head.length() > NAME_COLUMNS) {
              lines.add("  " + head);
              lines.add("  " + " ".repeat(NAME_COLUMNS) + "  " + firstSentence(signature));
            } else {
              lines.add("  " + pad(head, NAME_COLUMNS) + "  " + firstSentence(signature));
            }
          }
        });
    return lines;
  }

  /** Everything about the function, and the methods, called {@code name}; empty when unknown. */
  List<String> entries(String name) {
    List<String> lines = new ArrayList<>();
    for (Signature signature : all()) {
      if (signature.name().equals(name)) {
        if (!lines.isEmpty()) {
          lines.add("");
        }
        lines.addAll(entry(signature));
      }
    }
    return lines;
  }

  private static List<String> entry(Signature signature) {
    List<String> lines = new ArrayList<>();
    lines.add(call(signature));
    lines.add("");
    Paragraph.wrap(signature.documentation(), 76).forEach(line -> lines.add("  " + line));
    if (!signature.parameters().isEmpty()) {
      lines.add("");
      lines.add("  Parameters:");
      int width = signature.parameters().stream().mapToInt(p -> p.name().length()).max().orElse(0);
      for (Parameter parameter : signature.parameters()) {
        lines.add("    " + pad(parameter.name(), width) + "  " + describe(parameter));
      }
    }
    lines.add("");
    lines.add("  Result: " + result(signature));
    for (String note : notes(signature)) {
      lines.add("  Note:   " + note);
    }
    if (!signature.module().equals(TestBuiltins.MODULE)) {
      lines.add("  Manual: " + manual(signature));
    }
    return lines;
  }

  /** The whole reference as Markdown; docs/functions.md is this text. */
  String markdown() {
    StringBuilder page = new StringBuilder(1 << 16);
    if (ofTests) {
      page.append("# Functions of tests\n\n");
      page.append("What tests of programs may call beside all [functions](functions.md) that ");
      page.append("programs may, see [testing.md](testing.md). This page is generated:\n");
      page.append("`./pendant functions --tests --markdown > docs/testing-functions.md`.\n\n");
    } else {
      page.append("# Functions\n\n");
      page.append("Every function and method that a script may call, as Pendant implements them. ");
      page.append("This page is generated from the catalogue that the interpreter itself uses:\n");
      page.append("`./pendant functions --markdown > docs/functions.md`. ");
      page.append("Sections are those of the URScript manual for PolyScope 5.24.\n\n");
    }
    byModule.forEach(
        (module, signatures) ->
            page.append("- [")
                .append(module)
                .append("](#")
                .append(anchor(module))
                .append("): ")
                .append(signatures.size())
                .append('\n'));
    byModule.forEach(
        (module, signatures) -> {
          page.append("\n## ").append(module).append('\n');
          signatures.forEach(signature -> appendMarkdown(page, signature));
        });
    return page.toString();
  }

  private static void appendMarkdown(StringBuilder page, Signature signature) {
    page.append("\n### `").append(call(signature)).append("`\n\n");
    page.append(signature.documentation()).append('\n');
    if (!signature.parameters().isEmpty()) {
      page.append("\n| parameter | type | unit | default |\n|---|---|---|---|\n");
      for (Parameter parameter : signature.parameters()) {
        page.append("| `")
            .append(parameter.name())
            .append("` | ")
            .append(parameter.type().text())
            .append(" | ")
            .append(parameter.unit().symbol())
            .append(" | ")
            .append(parameter.required() ? "" : defaultMarkdown(parameter))
            .append(" |\n");
      }
    }
    page.append("\nResult: ").append(result(signature)).append('.');
    if (!signature.module().equals(TestBuiltins.MODULE)) {
      notes(signature).forEach(note -> page.append(' ').append(note).append('.'));
      page.append(" Manual: ").append(manual(signature)).append('.');
    }
    page.append('\n');
  }

  private static String defaultMarkdown(Parameter parameter) {
    String text = parameter.defaultText();
    return text.startsWith("<") ? plain(text) : "`" + text + "`";
  }

  private static String call(Signature signature) {
    String receiver = signature.receiver().map(type -> type.text() + ".").orElse("");
    return receiver + signature.head();
  }

  private static String describe(Parameter parameter) {
    StringBuilder text = new StringBuilder(parameter.type().text());
    if (parameter.unit() != Unit.NONE) {
      text.append(" in ").append(parameter.unit().symbol());
    }
    if (!parameter.required()) {
      text.append(", default ").append(plain(parameter.defaultText()));
    }
    return text.toString();
  }

  /** A default that is a description stands in angle brackets in a head, without them in text. */
  private static String plain(String defaultText) {
    return defaultText.startsWith("<") && defaultText.endsWith(">")
        ? defaultText.substring(1, defaultText.length() - 1)
        : defaultText;
  }

  private static String result(Signature signature) {
    if (signature.result() == Type.NONE) {
      return "none";
    }
    return signature.resultUnit() == Unit.NONE
        ? signature.result().text()
        : signature.result().text() + " in " + signature.resultUnit().symbol();
  }

  private static List<String> notes(Signature signature) {
    List<String> notes = new ArrayList<>();
    if (signature.physicalTime()) {
      notes.add("Takes robot time; a secondary program cannot call it");
    } else if (!signature.allowedInSecondary()) {
      notes.add("A secondary program cannot call it");
    }
    if (!signature.deprecated().isEmpty()) {
      notes.add("Deprecated: use " + signature.deprecated());
    }
    return notes;
  }

  private static String manual(Signature signature) {
    return "section " + signature.section();
  }

  /** The first sentence of the documentation. */
  static String firstSentence(Signature signature) {
    String text = signature.documentation();
    int end = text.indexOf(". ");
    return end < 0 ? text : text.substring(0, end + 1);
  }

  private static String anchor(String heading) {
    return heading.toLowerCase(Locale.ROOT).replace(' ', '-');
  }

  private static String pad(String text, int width) {
    return text + " ".repeat(Math.max(0, width - text.length()));
  }
}
