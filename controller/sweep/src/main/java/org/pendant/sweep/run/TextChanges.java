package org.pendant.sweep.run;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;

/** Text changes: what is different in the text of a variant's program. Mutable, for one variant. */
final class TextChanges {
  private final List<Change> changes = new ArrayList<>();

  /**
   * One change.
   *
   * @param end at {@code start} where text is added
   * @param rank of additions at one place, the lower first
   */
  private record Change(int start, int end, int rank, String text) {}

  /** Puts a text in place of a range. */
  void replace(SourceRange range, String text) {
    changes.add(new Change(range.start(), range.end(), 0, text));
  }

  /** Puts texts around a range; around one that is replaced, too. */
  void wrap(SourceRange range, String before, String after) {
    changes.add(new Change(range.start(), range.start(), -1, before));
    changes.add(new Change(range.end(), range.end(), -2, after));
  }

  /** Adds a text at a place. */
  void insert(int at, String text) {
    changes.add(new Change(at, at, 0, text));
  }

  /** The text with the changes; its lines have the same numbers. */
  Source in(Source source) {
    if (changes.isEmpty()) {
      return source;
    }
    List<Change> sorted = new ArrayList<>(changes);
    sorted.sort(Comparator.comparingInt(Change::start).thenComparingInt(Change::rank));
    StringBuilder text = new StringBuilder();
    int at = 0;
    for (Change each : sorted) {
      text.append(source.text(), at, each.start()).append(ByteText.asBytes(each.text()));
      at = Math.max(at, each.end());
    }
    text.append(source.text(), at, source.text().length());
    return Source.of(
        source.name(), text.toString().getBytes(java.nio.charset.StandardCharsets.ISO_8859_1));
  }
}
