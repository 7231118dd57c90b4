package org.pendant.editors.lsp.provider;

import java.util.List;
import org.eclipse.lsp4j.FormattingOptions;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextEdit;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.service.FormatOptions;
import org.pendant.language.service.FormatResult;

/** Formatting: blanks and line ends put in order; a text with syntax errors stays as it is. */
public final class Formatting {
  private static final int MAX_INDENTATION = 16;

  private Formatting() {}

  /** What lays the whole text out, with blocks indented by the tab size, 1 to 16 blanks. */
  public static List<TextEdit> of(Document document, FormattingOptions wanted) {
    int blanks = Math.clamp(wanted.getTabSize(), 1, MAX_INDENTATION);
    return switch (document.analysis().format(new FormatOptions(blanks))) {
      case FormatResult.Formatted(var edits) -> document.edits(edits);
      case FormatResult.Refused _ -> List.of();
    };
  }

  /** Only what stands in the lines of {@code range}, with the ends of the lines before them. */
  public static List<TextEdit> of(Document document, Range range, FormattingOptions wanted) {
    int first = range.getStart().getLine();
    int end = range.getEnd().getLine();
    // A selection of whole lines ends at the start of the line behind them.
    int last = range.getEnd().getCharacter() == 0 && end > first ? end - 1 : end;
    return of(document, wanted).stream()
        .filter(edit -> lineOf(edit) >= first && lineOf(edit) <= last)
        .toList();
  }

  /**
   * What a word or a line end that was just typed before {@code position} makes necessary: the
   * indentation of its line, once the text can be read.
   */
  public static List<TextEdit> onType(
      Document document, Position position, FormattingOptions wanted) {
    return of(document, wanted).stream()
        .filter(edit -> lineOf(edit) == position.getLine())
        .filter(Formatting::indents)
        .toList();
  }

  private static boolean indents(TextEdit edit) {
    Position start = edit.getRange().getStart();
    return start.getCharacter() == 0 || start.getLine() < lineOf(edit);
  }

  /** The line that an edit of blanks lays out: the one that follows them. */
  private static int lineOf(TextEdit edit) {
    return edit.getRange().getEnd().getLine();
  }
}
