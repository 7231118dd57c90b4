package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.service.Completion;

final class InsertionTest {

  /** Offers at the bar, chooses {@code label}, and marks the new caret by a bar. */
  private static String chosen(String marked, String label) {
    int caret = marked.indexOf('|');
    String text = marked.replace("|", "");
    Completion completion =
        AnalysedText.of("test.script", text, StandardBuiltins.create()).completions(caret).stream()
            .filter(each -> each.label().equals(label))
            .findFirst()
            .orElseThrow();
    Insertion insertion = Insertion.of(completion, text, Insertion.wordStart(text, caret), caret);
    String after =
        text.substring(0, insertion.edit().span().start())
            + insertion.edit().text()
            + text.substring(insertion.edit().span().end());
    return after.substring(0, insertion.caret()) + "|" + after.substring(insertion.caret());
  }

  @Test
  void functionsComeWithParenthesesAndTheCaretBetween() {
    assertEquals(
        "def main():\n  textmsg(|)\nend\n", chosen("def main():\n  text|\nend\n", "textmsg"));
  }

  @Test
  void argumentsThatAreNeededStandBetweenThem() {
    String text = "def main():\n  set_standard_dig\nend\n";
    int caret = text.indexOf("\nend");
    Completion completion =
        AnalysedText.of("test.script", text, StandardBuiltins.create()).completions(caret).stream()
            .filter(each -> each.label().equals("set_standard_digital_out"))
            .findFirst()
            .orElseThrow();
    Insertion insertion =
        Insertion.withArguments(completion, text, Insertion.wordStart(text, caret), caret);
    String after = Edit.apply(text, List.of(insertion.edit()));
    assertEquals("def main():\n  set_standard_digital_out(n, b)\nend\n", after);
    assertEquals(
        List.of("n", "b"),
        insertion.arguments().stream()
            .map(each -> after.substring(each.start(), each.end()))
            .toList());
  }

  @Test
  void replacesTheWholeWordAroundTheCaret() {
    assertEquals(
        "def main():\n  textmsg(|)\nend\n", chosen("def main():\n  text|xyz\nend\n", "textmsg"));
  }

  @Test
  void blocksAreIndentedLikeTheirLine() {
    assertEquals(
        "def main():\n  while |:\n    \n  end\nend\n",
        chosen("def main():\n  whi|\nend\n", "while"));
  }

  @Test
  void placesCountCharactersBehindAccents() {
    assertEquals(
        "def main():\n  # \u00e9\n  textmsg(|)\nend\n",
        chosen("def main():\n  # \u00e9\n  text|\nend\n", "textmsg"));
  }

  @Test
  void aLetterWithAnAccentIsNoPartOfAName() {
    assertEquals(1, Insertion.wordStart("\u00e9ab", 3));
  }
}
