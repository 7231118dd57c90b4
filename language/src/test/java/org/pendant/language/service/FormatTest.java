package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.language.parse.RandomTrees;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.parse.ScriptPrinter;
import org.pendant.language.parse.TreeShape;
import org.pendant.language.source.Source;

@Tag("slow")
final class FormatTest {

  @Test
  void blocksAreIndentedByTwo() {
    assertFormatted(
        """
        def prog():
          while True:
            if a:
              sync()
            elif b:
              halt
            else:
              # nothing to do
            end
          end
        end
        """,
        """
        def prog():
        while True:
              if a:
        sync()
           elif b:
        halt
        else:
        # nothing to do
        end
         end
        end
        """);
  }

  @Test
  void theIndentationIsAnOption() {
    assertEquals(
        "def f():\n    sync()\nend\n", format("def f():\nsync()\nend", new FormatOptions(4)));
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> new FormatOptions(0));
    assertEquals("indentation is 0 blanks, must be 1 to 16", refused.getMessage());
  }

  @Test
  void operatorsStandBetweenBlanksAndSignsAtTheirOperand() {
    assertFormatted("x = a + b * -c\n", "x=a+b*-  c");
    assertFormatted("y = not (a == b) and !c\n", "y  =  not(a==b)and ! c");
    assertFormatted("z = --1\n", "z = - - 1");
  }

  @Test
  void commasAreFollowedByABlankAndNamedArgumentsAreTight() {
    assertFormatted("movej([0, 1], a=1.4, v=-1)\n", "movej ( [ 0,1 ],a = 1.4 ,v= -1 )");
    assertFormatted("def f(a, b=2):\nend\n", "def f ( a,b = 2 ) :\nend");
    assertFormatted("x = m[0, 1] + p[1, 2, 3, 4, 5, 6][0]\n", "x=m [0,1]+p[1,2,3,4,5,6] [0]");
  }

  @Test
  void membersOfAStructAreGivenValuesAsVariablesAre() {
    assertFormatted("s = struct(a = f(x=1), b = 2)\n", "s=struct(a=f(x = 1),b=2)");
  }

  @Test
  void linesThatGoOnStandFurtherIn() {
    assertFormatted(
        """
        x = f(
            1,
            g(
                2
            )
        )
        ok = a and
            b
        while a or
            b:
          sync()
        end
        """,
        "x = f(\n1,\ng(\n2\n)\n)\nok = a and\nb\nwhile a or\nb:\nsync()\nend");
  }

  @Test
  void statementsOnOneLineStayThere() {
    assertFormatted("if a: b = 1 c = 2 end\n", "if a :b=1   c=2 end");
    assertFormatted("if a: if b:\n  sync()\nend end\n", "if a: if b:\nsync()\nend end");
  }

  @Test
  void atMostTwoBlankLinesStay() {
    assertFormatted("a = 1\n\n\nb = 2\n\nc = 3\n", "\n\na = 1\n\n\n\n\nb = 2\n\nc = 3\n\n\n");
    assertFormatted("", "\n \n");
  }

  @Test
  void commentsStayWhereTheyAreWithoutBlanksAtTheirEnd() {
    assertFormatted(
        "def f(): # head\n  # body\n  a = 1      # column\n  b = 22     # column\nend  #x\n",
        "def f(): # head\n# body   \na = 1      # column\nb = 22     # column\nend#x");
  }

  @Test
  void stringsAndLabelsAreNotTouched() {
    assertFormatted(
        "def f():\n  $ 1 \"a  =b\"   \"noBreak\"\n  textmsg(\"a=b ,c#  \")\nend\n",
        "def f():\n$ 1 \"a  =b\"   \"noBreak\"\ntextmsg( \"a=b ,c#  \" )\nend\n");
  }

  @Test
  void theLineEndsOfTheTextAreKept() {
    assertFormatted("if a:\r\n  sync()\r\nend\r\n", "if a:\r\nsync()\r\nend");
  }

  @Test
  void aTextWithSyntaxErrorsIsLeftAloneAndTheReasonIsGiven() {
    FormatResult result = Marked.analysis("x=1\ny = (2\n").format(FormatOptions.DEFAULT);
    FormatResult.Refused refused = assertInstanceOf(FormatResult.Refused.class, result);
    assertEquals(
        "line 3: `(` at 2:5 is not closed: found the end of the text, expected `)`",
        refused.reason());
  }

  @Test
  void onlyTheChangedPlacesAreEdited() {
    FormatResult result = Marked.analysis("a = 1\nb=2\n").format(FormatOptions.DEFAULT);
    assertEquals(
        new FormatResult.Formatted(List.of(TextEdit.insert(7, " "), TextEdit.insert(8, " "))),
        result);
  }

  @Test
  void formattedProgramsReadTheSameAndStayAsTheyAre() {
    for (int seed = 0; seed < 2000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      String text = new ScriptPrinter(random).print(new RandomTrees(random).statements(3));
      String context = "seed " + seed + ":\n" + text;
      Source before = Source.of("seed", text.getBytes(StandardCharsets.ISO_8859_1));
      Source after = formatted(before, FormatOptions.DEFAULT);
      assertEquals(shape(before), shape(after), context);
      assertEquals(after.text(), formatted(after, FormatOptions.DEFAULT).text(), context);
      assertEquals(solid(before), solid(after), context);
    }
  }

  private static String shape(Source source) {
    return TreeShape.of(ScriptParser.parseProgram(source).script());
  }

  private static String solid(Source source) {
    return source.text().replaceAll("\\s", "");
  }

  private static void assertFormatted(String expected, String text) {
    assertEquals(expected, format(text, FormatOptions.DEFAULT));
    assertEquals(expected, format(expected, FormatOptions.DEFAULT), "not stable");
  }

  private static String format(String text, FormatOptions options) {
    return formatted(Source.of("test.script", text), options).text();
  }

  private static Source formatted(Source source, FormatOptions options) {
    FormatResult result = ScriptAnalysis.of(source, new EditorCatalogue()).format(options);
    FormatResult.Formatted done = assertInstanceOf(FormatResult.Formatted.class, result);
    return TextEdit.apply(source, done.edits());
  }
}
