package org.pendant.editors.lsp.provider;

import java.util.List;
import org.pendant.language.service.Completion;
import org.pendant.language.source.ByteText;

/** Snippets: texts to insert with places to fill in, as the protocol writes them. */
final class Snippets {
  private Snippets() {}

  /** What {@code completion} inserts, with a tab stop for each argument and one for the caret. */
  static String of(Completion completion) {
    String insert = completion.insert();
    String before = escaped(insert.substring(0, completion.caret()));
    String after = escaped(insert.substring(completion.caret()));
    if (completion.arguments().isEmpty()) {
      return completion.caret() == insert.length() ? before : before + "$0" + after;
    }
    StringBuilder stops = new StringBuilder();
    List<String> arguments = completion.arguments();
    for (int i = 0; i < arguments.size(); i++) {
      stops.append(i == 0 ? "" : ", ");
      stops.append("${").append(i + 1).append(':').append(escaped(arguments.get(i))).append('}');
    }
    return before + stops + after + "$0";
  }

  private static String escaped(String bytes) {
    return ByteText.decoded(bytes).replace("\\", "\\\\").replace("$", "\\$").replace("}", "\\}");
  }
}
