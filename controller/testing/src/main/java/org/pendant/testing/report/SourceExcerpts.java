package org.pendant.testing.report;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.pendant.language.source.DiagnosticFormat;
import org.pendant.language.source.Source;
import org.pendant.language.source.VisibleText;
import org.pendant.testing.TestPlace;

/** Source excerpts: the lines that places are in, of files that are asked for once. */
final class SourceExcerpts {
  private final Function<String, Optional<Source>> sources;
  private final Map<String, Optional<Source>> known = new HashMap<>();

  /**
   * A line of an excerpt.
   *
   * @param number 1-based
   * @param caret what stands below the line that is meant; empty for one around it
   */
  record Line(int number, String text, Optional<String> caret) {}

  SourceExcerpts(Function<String, Optional<Source>> sources) {
    this.sources = sources;
  }

  /** The line, and below it the caret where a column is known; nothing without a text. */
  List<String> of(TestPlace place) {
    List<String> lines = new ArrayList<>();
    for (Line each : around(place, 0)) {
      lines.add(each.text());
      each.caret().filter(caret -> !caret.isEmpty()).ifPresent(lines::add);
    }
    return lines;
  }

  /** The line with {@code margin} lines above and below it; nothing without a text. */
  List<Line> around(TestPlace place, int margin) {
    Optional<Source> source = known.computeIfAbsent(place.file(), sources);
    if (source.isEmpty() || place.line() < 1 || place.line() > source.get().lineCount()) {
      return List.of();
    }
    List<Line> lines = new ArrayList<>();
    int last = Math.min(source.get().lineCount(), place.line() + margin);
    for (int i = Math.max(1, place.line() - margin); i <= last; i++) {
      boolean meant = i == place.line();
      int column = meant ? Math.max(1, place.column()) : 1;
      List<String> excerpt = DiagnosticFormat.excerpt(source.get(), i, column, 0);
      String caret = place.column() > 0 ? excerpt.getLast() : "";
      lines.add(
          new Line(
              i,
              VisibleText.of(excerpt.getFirst()),
              meant ? Optional.of(caret) : Optional.empty()));
    }
    return lines;
  }
}
