package org.pendant.script.variables;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.command.Reply;

final class VariableTracerTest {
  private final RunningProgram program = new RunningProgram();

  private double value(String name) {
    return program.state().traced().value(name);
  }

  @Test
  void nothingIsTracedUntilSomebodyAsks() {
    program.start("def program():", "  a = 1", "  sleep(1)", "end");
    assertSame(TracedVariables.NONE, program.state().traced());
    assertEquals(Double.NaN, value("a"));
  }

  @Test
  void aVariableIsReadInEveryFrame() {
    program.trace("test", "i");
    program.start(
        "def program():",
        "  i = 0",
        "  while True:",
        "    i = i + 1",
        "    sync()",
        "  end",
        "end");
    for (int i = 1; i < 50; i++) {
      assertEquals(i, value("i"));
      program.frames(1);
    }
  }

  @Test
  void partsOfAllKindsOfValuesAreRead() {
    program.trace(
        "test",
        "n",
        "b",
        "p[2]",
        "l[1]",
        "m[1, 0]",
        "t.inner.q[3]",
        "t.size",
        "poses[1][0]",
        "flags[0]");
    program.start(
        "def program():",
        "  n = -3",
        "  b = True",
        "  p = p[1, 2, 3, 0, 0, 0]",
        "  l = [0.5, 0.25]",
        "  m = [[1, 2], [3, 4]]",
        "  t = struct(size=7, inner=struct(q=p[0, 0, 0, 0.125, 0, 0]))",
        "  poses = [p[0, 0, 0, 0, 0, 0], p[8, 0, 0, 0, 0, 0]]",
        "  flags = [True, False]",
        "  sleep(1)",
        "end");
    assertEquals(
        List.of(-3.0, 1.0, 3.0, 0.25, 3.0, 0.125, 7.0, 8.0, 1.0),
        program.state().traced().names().stream().map(this::value).toList());
    assertEquals("m[1][0]", program.state().traced().names().get(4));
  }

  @Test
  void whatIsNotThereOrNoNumberIsNaN() {
    program.trace(
        "test", "none", "late", "s", "p", "p[6]", "l[9]", "m[0]", "m[0][5]", "m[7][0]", "n[0]",
        "n.x", "t.none");
    program.start(
        "def program():",
        "  s = \"text\"",
        "  n = 1",
        "  p = p[1, 2, 3, 0, 0, 0]",
        "  l = [0.5, 0.25]",
        "  m = [[1, 2], [3, 4]]",
        "  t = struct(size=7)",
        "  sleep(1)",
        "  late = 2",
        "end");
    for (String name : program.state().traced().names()) {
      assertEquals(Double.NaN, value(name), name);
    }
  }

  @Test
  void theSameObjectIsPublishedWhileNothingChanges() {
    program.trace("test", "a");
    program.start("def program():", "  a = 1", "  sleep(0.1)", "  a = 2", "  sleep(1)", "end");
    TracedVariables before = program.state().traced();
    program.frames(20);
    assertSame(before, program.state().traced());
    program.frames(60);
    assertEquals(2, value("a"));
    assertEquals(1, before.value("a"));
  }

  @Test
  void valuesStayAfterTheEndUntilTheNextProgram() {
    program.trace("test", "a");
    program.start("def program():", "  a = 1", "end").finish();
    assertEquals(1, value("a"));
    program.start("def program():", "  b = 1", "  sleep(1)", "end");
    assertEquals(Double.NaN, value("a"));
  }

  @Test
  void localsOfTheMainFunctionAreReadWhileItIsUnderWay() {
    program.trace("test", "count");
    program.start("def main():", "  local count = 4", "  sleep(0.1)", "end", "x = 1", "main()");
    assertEquals(4, value("count"));
    program.finish();
    assertEquals(Double.NaN, value("count"));
  }

  @Test
  void ownersHaveListsOfTheirOwn() {
    program.trace("plots", "a", "b");
    program.trace("record", "b", "c");
    assertEquals(List.of("a", "b", "c"), sorted());
    program.trace("plots", "d");
    assertEquals(List.of("b", "c", "d"), sorted());
    program.trace("record");
    assertEquals(List.of("d"), sorted());
    program.trace("plots");
    assertSame(TracedVariables.NONE, program.state().traced());
  }

  private List<String> sorted() {
    return program.state().traced().names().stream().sorted().toList();
  }

  @Test
  void moreThanSixtyFourAreRefused() {
    program.trace("plots", "a");
    String[] many = IntStream.range(0, 64).mapToObj(i -> "x" + i).toArray(String[]::new);
    Reply reply = program.trace("record", many);
    assertEquals(
        "65 variables would be traced in every frame, at most 64 can",
        assertInstanceOf(Reply.Refused.class, reply).refusal().text());
    assertEquals(List.of("a"), sorted());
    program.ask(new DebugCommand.TraceVariables("plots", List.of()));
    assertInstanceOf(Reply.Done.class, program.trace("record", many));
  }
}
