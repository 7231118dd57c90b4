package org.pendant.editors.lsp.provider;

import static org.pendant.editors.lsp.provider.AnswerTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Signature;

/** Explanations: what is known about a function or a name, as text in two forms. */
final class Explanations {
  private Explanations() {}

  /**
   * One explanation.
   *
   * @param head one line of code; may be empty
   * @param lines sentences
   */
  record Text(String head, List<String> lines) {
    Text {
      lines = List.copyOf(lines);
    }

    String plain() {
      List<String> all = new ArrayList<>();
      if (!head.isEmpty()) {
        all.add(head);
      }
      all.addAll(lines);
      return String.join("\n", all);
    }

    String markdown() {
      String code = head.isEmpty() ? "" : "```urscript\n" + head.replace("```", "") + "\n```\n";
      List<String> escaped = lines.stream().map(Explanations::escaped).toList();
      return (code + String.join("  \n", escaped)).stripTrailing();
    }
  }

  /** The function or method called {@code name}. */
  static Optional<Text> named(Catalogue catalogue, String name, ClientFeatures client) {
    return catalogue
        .function(name)
        .or(() -> catalogue.all().stream().filter(each -> each.name().equals(name)).findFirst())
        .map(signature -> of(signature, client));
  }

  static Text of(Signature signature, ClientFeatures client) {
    List<String> lines = new ArrayList<>();
    if (!signature.documentation().isEmpty()) {
      lines.add(signature.documentation());
    }
    signature.parameters().forEach(each -> lines.add(each.described()));
    if (!signature.deprecated().isEmpty()) {
      lines.add(client.shown(text("deprecated", signature.deprecated())));
    }
    if (!signature.section().isEmpty()) {
      lines.add(client.shown(text("manual", signature.section())));
    }
    return new Text(signature.head(), lines);
  }

  private static String escaped(String line) {
    StringBuilder escaped = new StringBuilder(line.length() + 8);
    line.chars()
        .forEach(
            each -> {
              if ("\\`*_{}[]<>#|".indexOf(each) >= 0) {
                escaped.append('\\');
              }
              escaped.append((char) each);
            });
    return escaped.toString();
  }
}
