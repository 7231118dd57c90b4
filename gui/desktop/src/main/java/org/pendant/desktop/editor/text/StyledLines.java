package org.pendant.desktop.editor.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.pendant.language.service.CharacterOffsets;
import org.pendant.language.service.HighlightToken;
import org.pendant.language.service.HighlightToken.Style;

/**
 * Styled lines: the colours of a whole text, line by line.
 *
 * @param lines every line
 * @param names what the text's own names are, for lines that are read alone
 */
record StyledLines(List<StyledLine> lines, Map<String, Style> names) {
  StyledLines {
    lines = List.copyOf(lines);
    names = Map.copyOf(names);
  }

  static StyledLines of(String text, List<HighlightToken> tokens, CharacterOffsets offsets) {
    List<StyledLine> lines = new ArrayList<>();
    Map<String, Style> names = new HashMap<>();
    int next = 0;
    for (int start = 0; start <= text.length(); ) {
      int newline = text.indexOf('\n', start);
      int end = newline < 0 ? text.length() : newline;
      StyledLine.Builder line = new StyledLine.Builder();
      while (next < tokens.size() && offsets.toCharacter(tokens.get(next).start()) < end) {
        HighlightToken token = tokens.get(next);
        int from = Math.max(start, offsets.toCharacter(token.start()));
        int to = offsets.toCharacter(token.end());
        line.add(token.style(), from - start, Math.min(to, end) - start);
        if (isOwnName(token.style())) {
          names.putIfAbsent(text.substring(from, to), token.style());
        }
        if (to > end) {
          break; // it continues in the next line
        }
        next++;
      }
      lines.add(line.of(text.substring(start, end)));
      start = end + 1;
    }
    return new StyledLines(lines, names);
  }

  private static boolean isOwnName(Style style) {
    return style == Style.FUNCTION || style == Style.VARIABLE || style == Style.PARAMETER;
  }
}
