package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.language.service.Completion.Kind;
import org.pendant.language.source.SourceRange;

/** What is offered at the caret, which is written {@code |}. */
final class CompletionTest {

  @Test
  void nearerNamesComeFirst() {
    String text =
        """
        def prog():
          mode = 1
          def moving(mo_parameter):
            local mo_local = 1
            mo|
          end
        end
        """;
    assertEquals(
        List.of("mo_parameter", "mo_local", "mode", "moving", "movej", "movel"),
        labels(text).subList(0, 6));
  }

  @Test
  void prefixesComeBeforeOtherCaseBeforeScatteredLetters() {
    assertEquals(List.of("set_standard_digital_out"), labels(inBody("ssdo|")));
    assertEquals(
        List.of("sl_x", "SL_y", "sleep").stream().sorted().toList(),
        labels(inBody("sl_x = 1\nSL_y = 2\nz = sl|")).subList(0, 3).stream().sorted().toList());
    assertEquals("sl_x", labels(inBody("SL_y = 2\nsl_x = 1\nz = sl|")).getFirst());
    assertEquals("SL_y", labels(inBody("SL_y = 2\nsl_x = 1\nz = sl|")).get(2));
  }

  @Test
  void theWholeWordIsReplacedAndTheCaretGoesBetweenTheBrackets() {
    Completion offer = offer(inBody("mov|ej"), "movej");
    assertEquals(new SourceRange(14, 19), offer.replaced());
    assertEquals("movej()", offer.insert());
    assertEquals(6, offer.caret());
  }

  @Test
  void whatTheTextCallsMostComesFirstAndThenWhatProgramsCallMost() {
    assertEquals(List.of("movej", "movel"), labels(inBody("mov|")));
    assertEquals(
        List.of("movel", "movej"), labels(inBody("movel(p1)\n  mov|"), Kind.BUILTIN).subList(0, 2));
    assertEquals(
        List.of("set_standard_digital_out", "set_analog_out", "set_digital_out"),
        labels(inBody("set|"), Kind.BUILTIN));
  }

  @Test
  void argumentsThatACallCannotDoWithoutArePlacesToFillIn() {
    assertEquals(List.of("q"), offer(inBody("mo|"), "movej").arguments());
    assertEquals(List.of("n", "b"), offer(inBody("ssdo|"), "set_standard_digital_out").arguments());
    assertEquals(List.of(), offer(inBody("sy|"), "sync").arguments());
    assertEquals(List.of(), offer(inBody("mo|([0, 0, 0, 0, 0, 0])"), "movej").arguments());
  }

  @Test
  void namesOfArgumentsComeInTheirOrder() {
    assertEquals(List.of("q=", "a=", "v="), labels(inBody("movej(|)"), Kind.ARGUMENT));
  }

  @Test
  void bracketsThatStandThereAreNotDoubled() {
    assertEquals("movej", offer(inBody("mo|([0, 0, 0, 0, 0, 0])"), "movej").insert());
    assertEquals("sync()", offer(inBody("sy|"), "sync").insert());
  }

  @Test
  void builtInsShowTheirUnitsAndOneSentence() {
    Completion offer = offer(inBody("mo|"), "movej");
    assertEquals("(q, a=1.4 rad/s², v=1.05 rad/s)", offer.detail());
    assertEquals("Moves all joints to a goal.", offer.documentation());
  }

  @Test
  void functionsOfTheTextShowTheCommentAboveThem() {
    Completion offer =
        offer(
            "# Opens the gripper.\ndef open_it(width=1):\nend\ndef prog():\n  op|\nend\n",
            "open_it");
    assertEquals(Kind.FUNCTION, offer.kind());
    assertEquals("(width=1)", offer.detail());
    assertEquals("Opens the gripper.", offer.documentation());
  }

  @Test
  void aLocalOfAnotherFunctionIsNotOffered() {
    String text =
        "def prog():\n  def f():\n    inside = 1\n  end\n  def g():\n    x = ins|\n  end\nend\n";
    assertFalse(labels(text).contains("inside"));
  }

  @Test
  void namedArgumentsAreOfferedThatAreNotGivenYet() {
    assertEquals(List.of("a=", "v="), labels(inBody("movej(q0, |)"), Kind.ARGUMENT));
    assertEquals(List.of("v="), labels(inBody("movej(q0, a=1, |"), Kind.ARGUMENT));
    assertEquals(List.of("a="), labels(inBody("movej(q0, |, v=1)"), Kind.ARGUMENT));
    assertEquals(List.of(), labels(inBody("movej(q0, a=|)"), Kind.ARGUMENT));
    assertEquals(List.of(), labels(inBody("movej([0, |])"), Kind.ARGUMENT));
    assertEquals("a: number in rad/s², default 1.4", offer(inBody("movej(q, |)"), "a=").detail());
  }

  @Test
  void membersOfAKnownStructAreOffered() {
    String text = inBody("part = struct(mass=1, place=2)\nother = struct(z=1)\nx = part.|");
    assertEquals(List.of("mass", "place"), labels(text, Kind.MEMBER));
  }

  @Test
  void membersOfAnUnknownValueAreThoseOfTheText() {
    String text = inBody("part = struct(mass=1)\ndef f(a):\n  a.| \nend\n");
    assertEquals(List.of("mass"), labels(text, Kind.MEMBER));
  }

  @Test
  void methodsAreThoseOfTheKindOfValue() {
    assertEquals(List.of("append", "length"), labels(inBody("l = [1]\nl.|"), Kind.METHOD));
    assertEquals(List.of("get_row"), labels(inBody("m = [[1]]\nx = m.|"), Kind.METHOD));
    assertEquals(List.of("append"), labels(inBody("l = [1]\nl.ap|\ny = 2"), Kind.METHOD));
    assertEquals(List.of(), labels(inBody("s = \"a\"\ns.|"), Kind.METHOD));
  }

  @Test
  void behindRunOnlyThreadsAreOffered() {
    String text = "def prog():\n  thread blink():\n  end\n  def f():\n  end\n  h = run |\nend\n";
    assertEquals(List.of("blink"), labels(text));
  }

  @Test
  void threadsAreNoFunctions() {
    String text = "def prog():\n  thread blink():\n  end\n  bl|\nend\n";
    assertFalse(labels(text).contains("blink"));
  }

  @Test
  void blocksAreWrittenWithTheIndentationOfTheLine() {
    Completion offer = offer("def prog():\n  whi|\nend\n", "while");
    assertEquals(Kind.SNIPPET, offer.kind());
    assertEquals("while :\n    \n  end", offer.insert());
    assertEquals(6, offer.caret());
  }

  @Test
  void aChoiceByValueIsWrittenWithIfAndElif() {
    Completion offer = offer(inBody("swi|"), "switch");
    String text = "def prog():\n  " + offer.insert().replace("choice = ", "choice = 1") + "\nend\n";
    assertEquals(List.of(), Marked.analysis(text).diagnostics());
  }

  @Test
  void wordsAreOfferedWhereTheyFit() {
    assertTrue(labels(inBody("while a:\n  |\nend")).contains("break"));
    assertFalse(labels(inBody("|")).contains("break"));
    assertFalse(labels(inBody("while a:\n  def f():\n    |\n  end\nend")).contains("break"));
    assertTrue(labels(inBody("if a:\n  el|\nend")).contains("elif"));
    assertFalse(labels(inBody("el|")).contains("elif"));
    assertTrue(labels("se|").contains("sec"));
    assertFalse(labels(inBody("se|")).contains("sec"));
    assertFalse(labels(inBody("x = wh|")).contains("while"));
    assertTrue(labels(inBody("x = Tr|")).contains("True"));
  }

  @Test
  void behindAValueOnlyOperatorsAreOffered() {
    assertEquals(List.of("and", "or", "xor"), labels(inBody("if a |")));
  }

  @Test
  void nothingIsOfferedInStringsCommentsNumbersAndForNewNames() {
    assertEquals(List.of(), labels(inBody("textmsg(\"mo|\")")));
    assertEquals(List.of(), labels(inBody("textmsg(\"mo|")));
    assertEquals(List.of(), labels(inBody("# mo|")));
    assertEquals(List.of(), labels(inBody("x = 12|")));
    assertEquals(List.of(), labels(inBody("def mo|")));
    assertEquals(List.of(), labels(inBody("def f(mo|):\nend")));
    assertEquals(List.of(), labels(inBody("local mo|")));
    assertEquals(List.of(), labels(inBody("$ 1 \"mo|")));
  }

  @Test
  void behindGlobalTheGlobalsAreOffered() {
    assertEquals(List.of("counter"), labels(inBody("counter = 1\ndef f():\n  global co|\nend")));
  }

  @Test
  void halfAProgramIsEnough() {
    assertTrue(labels("def prog():\n  counter = 1\n  while cou|").contains("counter"));
    assertTrue(labels("def prog():\n  counter = 1\n  movej(cou|\n  x = 2").contains("counter"));
    assertTrue(labels("thread t(): local my_x = 1 x = (my|").contains("my_x"));
    assertTrue(labels("|").contains("def"));
  }

  @Test
  void everyPlaceOfATextHasAnAnswer() {
    String text = "def f(a, b=[1]):\n $ 1 \"l\"\n x = a.b(c=1).d[p[1,2,3,4,5,6]] # c\n 'x' \"y\nen";
    ScriptAnalysis analysis = Marked.analysis(text);
    for (int offset = 0; offset <= text.length(); offset++) {
      for (Completion offer : analysis.completions(offset)) {
        assertTrue(offer.caret() <= offer.insert().length(), offer.toString());
      }
      analysis.signatureHelp(offset);
      analysis.hover(offset);
      analysis.references(offset);
    }
  }

  private static String inBody(String body) {
    return "def prog():\n  " + body + "\nend\n";
  }

  private static List<String> labels(String text) {
    Marked marked = Marked.of(text);
    return marked.analysis().completions(marked.caret()).stream().map(Completion::label).toList();
  }

  private static List<String> labels(String text, Kind kind) {
    Marked marked = Marked.of(text);
    return marked.analysis().completions(marked.caret()).stream()
        .filter(offer -> offer.kind() == kind)
        .map(Completion::label)
        .toList();
  }

  private static Completion offer(String text, String label) {
    Marked marked = Marked.of(text);
    return marked.analysis().completions(marked.caret()).stream()
        .filter(offer -> offer.label().equals(label))
        .findFirst()
        .orElseThrow();
  }
}
