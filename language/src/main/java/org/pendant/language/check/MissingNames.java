package org.pendant.language.check;

import static org.pendant.language.check.CheckTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;

/**
 * Missing names: tells one once for all its uses, as people read a list of mistakes; where each use
 * is marked in the text, what {@link Checker} says of each is better.
 */
public final class MissingNames {
  static final String FUNCTION = "unknown-function";
  static final String VARIABLE = "unknown-variable";

  /** So many further uses are named with their lines. */
  private static final int SHOWN = 3;

  /** What uses of the same missing name have in common. */
  private record Missing(String code, Diagnostic.Severity severity, String name) {}

  private MissingNames() {}

  /**
   * The diagnostics of {@code source}, with those of one missing name put together in the first.
   */
  public static List<Diagnostic> together(Source source, List<Diagnostic> diagnostics) {
    Map<Missing, List<Diagnostic>> uses = new LinkedHashMap<>();
    for (Diagnostic each : diagnostics) {
      if (isMissing(each)) {
        uses.computeIfAbsent(missing(source, each), _ -> new ArrayList<>()).add(each);
      }
    }
    List<Diagnostic> together = new ArrayList<>();
    for (Diagnostic each : diagnostics) {
      if (isMissing(each)) {
        // the first use stands for all, which are then gone
        Optional.ofNullable(uses.remove(missing(source, each)))
            .ifPresent(all -> together.add(withOthers(source, each, all.subList(1, all.size()))));
      } else {
        together.add(each);
      }
    }
    return together;
  }

  private static boolean isMissing(Diagnostic diagnostic) {
    return diagnostic.code().equals(FUNCTION) || diagnostic.code().equals(VARIABLE);
  }

  private static Missing missing(Source source, Diagnostic diagnostic) {
    return new Missing(diagnostic.code(), diagnostic.severity(), source.text(diagnostic.range()));
  }

  private static Diagnostic withOthers(Source source, Diagnostic first, List<Diagnostic> others) {
    if (others.isEmpty()) {
      return first;
    }
    String lines =
        others.stream()
            .limit(SHOWN)
            .map(each -> Integer.toString(source.line(each.range().start())))
            .collect(Collectors.joining(", "));
    String message =
        switch (others.size()) {
          case 1 -> text("andOneMore", first.message(), lines);
          case 2, SHOWN -> text("andMore", first.message(), others.size(), lines);
          default -> text("andMany", first.message(), others.size(), lines);
        };
    return new Diagnostic(first.code(), first.severity(), first.range(), message, first.wireText());
  }
}
