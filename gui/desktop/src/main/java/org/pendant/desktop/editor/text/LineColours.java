package org.pendant.desktop.editor.text;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.language.service.CharacterOffsets;
import org.pendant.language.service.HighlightToken;
import org.pendant.language.service.HighlightToken.Style;
import org.pendant.language.service.Highlighting;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.Source;

/**
 * Line colours: the colours of every line. Analyses set them all; between two of them a line that
 * has changed is read alone, with the names that the last analysis knew, so that a key costs one
 * line and not the text.
 */
public final class LineColours {
  private final Catalogue catalogue;
  private Map<String, Style> names = Map.of();
  private List<StyledLine> lines = new ArrayList<>();

  /** Knows no line yet. */
  public LineColours(Catalogue catalogue) {
    this.catalogue = catalogue;
  }

  /**
   * Takes over what an analysis found.
   *
   * @return the lines between which all are that have other colours now, from 0; empty for none
   */
  public Optional<Changed> set(AnalysedText analysed) {
    List<StyledLine> before = lines;
    lines = new ArrayList<>(analysed.lines());
    names = analysed.names();
    return changed(before, lines);
  }

  /** The first and the last line that have changed, from 0. */
  public record Changed(int first, int last) {}

  private static Optional<Changed> changed(List<StyledLine> before, List<StyledLine> after) {
    int both = Math.min(before.size(), after.size());
    int first = 0;
    while (first < both && before.get(first).equals(after.get(first))) {
      first++;
    }
    int last = Math.max(before.size(), after.size()) - 1;
    if (before.size() == after.size()) {
      while (last > first && before.get(last).equals(after.get(last))) {
        last--;
      }
    }
    return first > last ? Optional.empty() : Optional.of(new Changed(first, last));
  }

  /**
   * Moves colours with their lines.
   *
   * @param line the first line that changed, from 0
   * @param removed how many lines went behind it
   * @param inserted how many came behind it
   */
  public void moved(int line, int removed, int inserted) {
    int from = Math.min(line + 1, lines.size());
    lines.subList(from, Math.min(from + removed, lines.size())).clear();
    lines.addAll(from, Collections.nCopies(inserted, new StyledLine("", List.of())));
  }

  /** The colours of line {@code index} (from 0), which reads {@code text}. */
  public StyledLine line(int index, CharSequence text) {
    if (index < lines.size() && lines.get(index).isOf(text)) {
      return lines.get(index);
    }
    StyledLine read = alone(text.toString());
    while (lines.size() <= index) {
      lines.add(new StyledLine("", List.of()));
    }
    lines.set(index, read);
    return read;
  }

  private StyledLine alone(String text) {
    CharacterOffsets offsets = CharacterOffsets.of(text);
    StyledLine.Builder line = new StyledLine.Builder();
    for (HighlightToken token : Highlighting.of(Source.of("line", text), catalogue)) {
      int start = offsets.toCharacter(token.start());
      int end = offsets.toCharacter(token.end());
      Style style = token.style();
      if (style == Style.UNKNOWN || style == Style.VARIABLE) {
        style = names.getOrDefault(text.substring(start, end), style);
      }
      line.add(style, start, end);
    }
    return line.of(text);
  }
}
