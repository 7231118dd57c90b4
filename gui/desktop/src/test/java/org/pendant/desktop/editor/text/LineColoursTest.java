package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.service.HighlightToken.Style;
import org.pendant.language.signature.Catalogue;

final class LineColoursTest {
  private static final String TEXT = "def grip(width):\n  # \u00e9\n  sync()\n  grip(width)\nend\n";

  private final Catalogue catalogue = StandardBuiltins.create();
  private final LineColours colours = new LineColours(catalogue);

  private static List<Style> styles(StyledLine line) {
    return line.runs().stream().map(StyledLine.Run::style).toList();
  }

  @Test
  void everyLineHasTheColoursOfTheAnalysis() {
    colours.set(AnalysedText.of("test.script", TEXT, catalogue));

    assertEquals(
        List.of(Style.KEYWORD, Style.FUNCTION, Style.PARAMETER),
        styles(colours.line(0, "def grip(width):")));
    assertEquals(
        List.of(new StyledLine.Run(Style.COMMENT, 2, 5)), colours.line(1, "  # \u00e9").runs());
    assertEquals(
        List.of(Style.FUNCTION, Style.PARAMETER), styles(colours.line(3, "  grip(width)")));
  }

  @Test
  void aLineThatHasChangedIsReadAloneWithTheNamesThatAreKnown() {
    colours.set(AnalysedText.of("test.script", TEXT, catalogue));
    StyledLine line = colours.line(2, "  grip(width + 1)");

    assertEquals(
        List.of(Style.FUNCTION, Style.PARAMETER, Style.OPERATOR, Style.NUMBER), styles(line));
    assertSame(line, colours.line(2, "  grip(width + 1)"));
  }

  @Test
  void coloursMoveWithTheirLines() {
    colours.set(AnalysedText.of("test.script", TEXT, catalogue));
    StyledLine call = colours.line(3, "  grip(width)");
    colours.moved(0, 0, 2);
    assertSame(call, colours.line(5, "  grip(width)"));
    colours.moved(0, 2, 0);
    assertSame(call, colours.line(3, "  grip(width)"));
  }

  @Test
  void onlyTheLinesBetweenThoseOfOtherColoursArePaintedAgain() {
    colours.set(AnalysedText.of("test.script", TEXT, catalogue));
    AnalysedText same = AnalysedText.of("test.script", TEXT, catalogue);
    assertEquals(Optional.empty(), colours.set(same));
    AnalysedText other =
        AnalysedText.of("test.script", TEXT.replace("sync()", "textmsg(1)"), catalogue);
    assertEquals(Optional.of(new LineColours.Changed(2, 2)), colours.set(other));
    AnalysedText longer = AnalysedText.of("test.script", TEXT + "grip(1)\n", catalogue);
    assertEquals(Optional.of(new LineColours.Changed(2, 6)), colours.set(longer));
  }
}
