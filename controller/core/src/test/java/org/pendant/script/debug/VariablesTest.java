package org.pendant.script.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/** What a held program shows, and what can be changed in it. */
class VariablesTest {
  private static final String PROGRAM =
      """
      def prog():
        i = 1
        f = 0.5
        b = True
        s = "text"
        p = p[1, 2, 3, 0, 0, 0]
        l = make_list(3, 0, 5)
        m = [[1, 2], [3, 4]]
        t = struct(x = 1, inner = struct(q = p, n = [7, 8]))
        big = make_list(100000, 1, 100000)
        calls = 0
        def count():
          calls = calls + 1
          return calls
        end
        thread helper(): sync() end
        def ending(h): calls = 9 kill h end
        def halting(): calls = 9 halt end
        def work(a, c=2):
          local i = 10
          textmsg(i)
          local late = 5
          textmsg(late)
        end
        work(4)
        textmsg(i, f)
        textmsg(s, l)
        textmsg(m, t)
        textmsg(p, b)
      end
      """;

  private final DebugFixture fixture = new DebugFixture();
  private final Debugger debugger = fixture.debugger;

  @BeforeEach
  void stopInTheFunction() {
    debugger.set(Breakpoint.at(21));
    fixture.start(PROGRAM).go();
  }

  private Variable global(String name) {
    return debugger.globals().stream().filter(v -> v.name().equals(name)).findAny().orElseThrow();
  }

  @Test
  void parametersAndLocalsOfACallAreShown() {
    List<Variable> variables = debugger.variables(0, 2);
    assertEquals(List.of("a", "c", "i", "late"), variables.stream().map(Variable::name).toList());
    assertEquals(List.of("4", "2", "10", ""), variables.stream().map(Variable::text).toList());
    assertEquals(Optional.empty(), variables.getLast().kind());
  }

  @Test
  void globalsAreShownWithKindTextAndChildren() {
    assertEquals(new Variable("i", "i", Optional.of(ValueKind.INT), "1", 0), global("i"));
    assertEquals(
        new Variable("m", "m", Optional.of(ValueKind.MATRIX), "[[1, 2], [3, 4]]", 4), global("m"));
    assertEquals(
        new Variable("p", "p", Optional.of(ValueKind.POSE), "p[1, 2, 3, 0, 0, 0]", 6), global("p"));
    assertEquals(2, global("t").children());
  }

  @Test
  void aHugeValueIsCutOff() {
    Variable big = global("big");
    assertEquals(100000, big.children());
    assertTrue(big.text().length() < 220, big.text());
    assertTrue(big.text().endsWith(", ...]"), big.text());
  }

  @Test
  void childrenComeInPartsAndNameWhatToAssignTo() throws ScriptError {
    List<Variable> part = debugger.children(0, 1, "big", 99_998, 1000);
    assertEquals(List.of("[99998]", "[99999]"), part.stream().map(Variable::name).toList());
    List<Variable> elements = debugger.children(0, 1, "m", 2, 2);
    assertEquals(
        List.of("m[1, 0]", "m[1, 1]"), elements.stream().map(Variable::expression).toList());
    List<Variable> members = debugger.children(0, 1, "t", 0, 10);
    assertEquals("t.inner", members.getLast().expression());
    List<Variable> inner = debugger.children(0, 1, "t.inner", 0, 10);
    assertEquals("t.inner.q", inner.getFirst().expression());
    assertEquals("(l + 1)[0]", debugger.children(0, 1, "l + 1", 0, 1).getFirst().expression());
    assertThrows(IllegalArgumentException.class, () -> debugger.children(0, 1, "big", 0, 1001));
    assertThrows(IllegalArgumentException.class, () -> debugger.children(0, 1, "big", -1, 1));
  }

  @Test
  void namesMeanWhatTheyMeanInTheCall() throws ScriptError {
    assertEquals("10", fixture.value("i"));
    assertEquals("1", debugger.evaluate(0, 1, "i").text());
    assertEquals("16.5", fixture.value("a + c + i + f"));
    assertEquals("error: late has no value yet", fixture.value("late"));
  }

  @Test
  void whatIsNoExpressionIsRefused() {
    assertEquals(
        "error: unexpected the end of the text: expected a value behind `+`", fixture.value("1 +"));
    assertEquals("error: there is no expression", fixture.value(" "));
    assertEquals("error: 1 x = 2 is not an expression", fixture.value("1 x = 2"));
    assertEquals(
        "error: variable nothing_such is never assigned", fixture.value("nothing_such + 1"));
    assertEquals("error: sqrt has 2 arguments, expected sqrt(f)", fixture.value("sqrt(1, 2)"));
  }

  @Test
  void whatTouchesThreadsOrTimeIsRefusedBeforeAnythingHasRun() {
    String why = ", an expression must be over at once and leave threads alone";
    assertEquals("error: sleep takes robot time" + why, fixture.value("sleep(1)"));
    assertEquals("error: run starts a thread" + why, fixture.value("run helper()"));
    assertEquals("error: kill ends a thread" + why, fixture.value("ending(1)"));
    assertEquals("error: halt ends the program" + why, fixture.value("halting()"));
    assertEquals("0", fixture.value("calls"));
  }

  @Test
  void aWatchChangesNothingWhetherItSucceedsOrFails() {
    assertEquals("1", fixture.value("count()"));
    assertEquals("1", fixture.value("count()"));
    assertTrue(fixture.value("count() + \"a\"").startsWith("error: "));
    fixture.value("l.append(count())");
    assertEquals("0", fixture.value("calls"));
    assertEquals("[0, 0, 0]", fixture.value("l"));
  }

  @Test
  void anExpressionThatComputesForEverIsGivenUp() {
    DebugFixture other = new DebugFixture();
    other.debugger.set(Breakpoint.at(7));
    other
        .start(
            """
            def prog():
              def endless():
                while True:
                  x = 1
                end
              end
              textmsg(1)
            end
            """)
        .go();
    assertEquals("error: it computes for more than 1 ms", other.value("[endless()]"));
  }

  @Test
  void everyKindOfVariableCanBeChanged() {
    assertEquals("11", fixture.assign("i", "i + 1"));
    assertEquals("0.75", fixture.assign("f", "0.75"));
    assertEquals("False", fixture.assign("b", "False"));
    assertEquals("new", fixture.assign("s", "\"new\""));
    assertEquals("p[9, 0, 0, 0, 0, 0]", fixture.assign("p", "p[9, 0, 0, 0, 0, 0]"));
    assertEquals("8", fixture.assign("p[1]", "8"));
    assertEquals("[1, 2]", fixture.assign("l", "[1, 2]"));
    assertEquals("6", fixture.assign("l[1]", "6"));
    assertEquals("5", fixture.assign("m[1, 0]", "5"));
    assertEquals("3", fixture.assign("t.x", "3"));
    assertEquals("4", fixture.assign("t.inner.q[2]", "4"));
    assertEquals("0", fixture.assign("t.inner.n[0]", "0"));
    fixture.finish();
    assertEquals(
        List.of(
            "11",
            "5",
            "10.75",
            "new[1, 6]",
            "[[1, 2], [5, 4]]{x = 3, inner = {q = p[1, 2, 4, 0, 0, 0], n = [0, 8]}}",
            "p[9, 8, 0, 0, 0, 0]False"),
        fixture.messages());
  }

  @Test
  void aVariableWithoutAValueCanBeGivenOne() {
    assertEquals("1", fixture.assign("late", "1"));
  }

  @Test
  void theRulesOfAssignmentHold() {
    assertTrue(fixture.assign("i", "\"text\"").startsWith("error: "));
    assertEquals("10", fixture.value("i"));
    assertTrue(fixture.assign("l", "[1, 2, 3, 4, 5, 6]").startsWith("error: "));
    assertTrue(fixture.assign("l[3]", "1").startsWith("error: index"));
    assertTrue(fixture.assign("t.none", "1").startsWith("error: "));
    assertTrue(fixture.assign("m[0, 0]", "\"a\"").startsWith("error: "));
    assertEquals("[0, 0, 0]", fixture.value("l"));
    assertEquals(
        "error: fresh is no variable here, only one that is there can change",
        fixture.assign("fresh", "1"));
    assertEquals(
        "error: local i is not a variable or a part of one", fixture.assign("local i", "1"));
  }

  @Test
  void aVariableOfAProgramThatIsNotHeldChangesBetweenTwoFrames() throws ScriptError {
    DebugFixture other = new DebugFixture();
    other.start("def prog():\n  a = 1\n  sleep(0.1)\n  textmsg(a)\nend\n").advance(3);
    assertEquals("1", other.debugger.globals().getFirst().text());
    assertEquals("2", other.debugger.assign(0, 1, "a", "2").text());
    other.go();
    assertEquals(List.of("2"), other.messages());
    assertEquals(
        "no program is running",
        assertThrows(IllegalArgumentException.class, () -> other.debugger.assign(0, 1, "a", "3"))
            .getMessage());
  }

  @Test
  void callsThatAreNotThereAreRefused() {
    assertEquals(
        "call is 3, must be 1 to 2 in thread 0",
        assertThrows(IllegalArgumentException.class, () -> debugger.variables(0, 3)).getMessage());
  }
}
