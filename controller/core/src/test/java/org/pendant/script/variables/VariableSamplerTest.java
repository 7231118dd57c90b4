package org.pendant.script.variables;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

final class VariableSamplerTest {
  private final RunningProgram program = new RunningProgram();

  @Test
  void thereIsNothingBeforeTheFirstProgram() {
    program.frames(50);
    assertSame(VariableSamples.NONE, program.samples());
  }

  @Test
  void theFirstFrameOfAProgramHasItsVariablesInTheOrderOfTheirAssignment() {
    program.start("def program():", "  other = 0", "end").finish();
    assertEquals(1, program.samples().run());
    program.start(
        "def program():",
        "  zero = 0",
        "  global pose = p[1, 2, 3, 0, 0, 0.5]",
        "  name = \"bolt\"",
        "  sleep(1)",
        "  later = 1",
        "end");
    assertEquals(
        List.of("zero = 0", "pose = p[1, 2, 3, 0, 0, 0.5]", "name = bolt", "later = "),
        RunningProgram.texts(program.samples().globals()));
    assertEquals(2, program.samples().run());
    assertEquals(Optional.empty(), program.sample("later").value());
    assertEquals(Optional.of(ValueKind.POSE), program.sample("pose").value().map(Value::kind));
  }

  @Test
  void valuesAreTakenEveryTwentyFramesAndAtTheEnd() {
    program.start(
        "def program():",
        "  i = 0",
        "  while i < 90:",
        "    i = i + 1",
        "    sync()",
        "  end",
        "end");
    assertEquals("1", program.sample("i").variable().text());
    program.frames(19);
    assertEquals("1", program.sample("i").variable().text());
    program.frames(1);
    assertEquals("21", program.sample("i").variable().text());
    program.finish();
    assertEquals("90", program.sample("i").variable().text());
    VariableSamples last = program.samples();
    program.frames(100);
    assertSame(last, program.samples());
  }

  @Test
  void valuesAreTakenWhereTheProgramComesToAnotherLine() {
    program.start("def program():", "  i = 0", "  sleep(0.012)", "  i = 1", "  sleep(1)", "end");
    assertEquals("0", program.sample("i").variable().text());
    program.frames(6);
    assertEquals("1", program.sample("i").variable().text());
  }

  @Test
  void manyVariablesAreNotTakenForEachLine() {
    program.start(
        "def program():",
        "  list = [" + "1, ".repeat(299) + "1]",
        "  sleep(0.012)",
        "  list[0] = 2",
        "  sleep(1)",
        "end");
    program.frames(6);
    assertEquals("1", program.sample("list").parts(1).getFirst().variable().text());
    program.frames(20);
    assertEquals("2", program.sample("list").parts(1).getFirst().variable().text());
  }

  @Test
  void whatHasNotChangedIsTheSameObject() {
    program.start(
        "def program():",
        "  list = [1, 2, 3]",
        "  text = \"abc\"",
        "  part = struct(name=\"bolt\", sizes=[4, 5])",
        "  i = 0",
        "  sleep(0.1)",
        "  i = 1",
        "  sleep(1)",
        "end");
    VariableSamples first = program.samples();
    program.frames(25);
    assertSame(first, program.samples());
    program.frames(60);
    assertNotSame(first, program.samples());
    assertSame(first.globals().get(0), program.samples().globals().get(0));
    assertSame(first.globals().get(2), program.samples().globals().get(2));
    assertEquals("1", program.sample("i").variable().text());
  }

  @Test
  void aSampleDoesNotChangeWithTheProgramNorByItsReaders() throws ScriptError {
    program.start(
        "def program():",
        "  list = [1, 2, 3]",
        "  sleep(0.1)",
        "  list[0] = 9",
        "  sleep(1)",
        "end");
    VariableSample sample = program.sample("list");
    ((ListValue) sample.value().orElseThrow()).set(1, Value.of(7));
    program.frames(80);
    assertEquals("[1, 2, 3]", sample.variable().text());
    assertEquals("[9, 2, 3]", program.sample("list").variable().text());
  }

  @Test
  void longListsAndStringsAreCutAndTellTheirLength() {
    program.start(
        "def program():",
        "  many = make_list(5000, 7, 5000)",
        "  text = \"" + "0123456789".repeat(102) + "\"",
        "  matrix = [[1, 2], [3, 4]]",
        "  parts = struct(name=\"bolt\", many=many)",
        "  sleep(1)",
        "end");
    VariableSample many = program.sample("many");
    assertEquals(5000, many.length());
    assertEquals(5000, many.variable().children());
    assertEquals(VariableSampler.MAX_PARTS, many.kept() + 1);
    assertTrue(many.variable().text().length() < 250, many.variable().text());
    assertEquals(
        BoundedCopy.MAX_BYTES, program.sample("text").value().orElseThrow().text().length());
    assertTrue(program.sample("parts.many").kept() < VariableSampler.MAX_PARTS);
    VariableSamples before = program.samples();
    program.frames(200);
    assertSame(before, program.samples(), "also what was cut is compared");
  }

  @Test
  void partsAreFoundByTheirPath() {
    program.start(
        "def program():",
        "  pose = p[1, 2, 3, 0, 0, 0.5]",
        "  matrix = [[1, 2, 3], [4, 5, 6]]",
        "  part = struct(name=\"bolt\", sizes=[4, 5])",
        "  sleep(1)",
        "end");
    assertEquals("0.5", program.sample("pose[5]").variable().text());
    assertEquals("6", program.sample("matrix[1, 2]").variable().text());
    assertEquals("5", program.sample("part.sizes[1]").variable().text());
    assertEquals("part.sizes[1]", program.sample("part.sizes[1]").expression());
    assertEquals(
        List.of("name = bolt", "sizes = [4, 5]"),
        RunningProgram.texts(program.sample("part").parts(10)));
    for (String none : List.of("pose[6]", "matrix[2, 0]", "matrix[1]", "part.size", "other")) {
      assertTrue(program.samples().find(VariablePath.of(none)).isEmpty(), none);
    }
  }

  @Test
  void aFragmentShowsTheLocalsOfTheFunctionThatItsLastLineCalls() {
    program.start(
        "speed = 3",
        "def helper(a):",
        "  local hidden = a",
        "  sleep(0.02)",
        "end",
        "def main():",
        "  part = 5",
        "  local count = 1",
        "  helper(2)",
        "  count = count + speed",
        "  sleep(1)",
        "end",
        "main()");
    assertEquals("main", program.samples().mainFunction());
    assertEquals(List.of("speed = 3"), RunningProgram.texts(program.samples().globals()));
    assertEquals(
        List.of("part = 5", "count = 1"), RunningProgram.texts(program.samples().locals()));
    program.frames(40);
    assertEquals(
        List.of("part = 5", "count = 4"), RunningProgram.texts(program.samples().locals()));
    program.finish();
    assertEquals(List.of(), RunningProgram.texts(program.samples().locals()));
  }

  @Test
  void everyVariableOfAProgramsOwnFunctionIsGlobal() {
    program.start("def main():", "  a = 1", "  local b = 2", "  sleep(1)", "end");
    assertEquals(List.of("a = 1", "b = 2"), RunningProgram.texts(program.samples().globals()));
    assertEquals("", program.samples().mainFunction());
  }

  @Test
  void aStoppedProgramKeepsItsVariables() {
    program.start("def program():", "  a = 1", "  sleep(9)", "end");
    program.ask(new ProgramCommand.StopProgram());
    assertEquals("1", program.sample("a").variable().text());
  }

  @Test
  void tooManyVariablesAreCountedButNotCopied() {
    StringBuilder text = new StringBuilder("def program():\n  l = make_list(990, 1, 990)\n");
    for (int i = 0; i < 20; i++) {
      text.append("  l").append(i).append(" = l\n");
    }
    program.start(text.append("  sleep(5)\nend").toString());
    VariableSamples samples = program.samples();
    assertEquals(21, samples.globals().size() + samples.omitted());
    assertTrue(samples.omitted() > 0, "omitted " + samples.omitted());
    program.frames(VariableSampler.FRAMES);
    assertSame(samples, program.samples());
  }

  @Test
  void aHeldProgramShowsWhatADebuggerChanges() {
    program.start("def program():", "  a = 1", "  sleep(9)", "end");
    program.ask(new DebugCommand.Debug(debugger -> debugger.pause()));
    program.ask(
        new DebugCommand.Debug(
            debugger -> {
              try {
                debugger.assign(0, 1, "a", "5");
              } catch (ScriptError e) {
                throw new IllegalArgumentException(e);
              }
            }));
    program.frames(VariableSampler.FRAMES);
    assertEquals("5", program.sample("a").variable().text());
  }
}
