package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.body;
import static org.pendant.project.program.script.TestTrees.once;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.tree;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;

/** What External Control nodes generate, with and without the script of a driver. */
class ExternalControlTextTest {
  private static final ControlScript SENT =
      ControlScript.of(
          ControlHost.STANDARD,
          """
          # HEADER_BEGIN
          def control():
            sync()
          end
          # HEADER_END

          # NODE_CONTROL_LOOP_BEGINS
          control()
          """);

  private static ProgramNode control() {
    return node(new ForeignStep.Contributed("FZI", ExternalControl.TYPE, List.of(), List.of()));
  }

  private static GeneratedScript generated(ProgramTree tree) {
    return ScriptGenerator.generate("test", tree, Installation.NONE, Optional.of(SENT));
  }

  private static List<String> lines(GeneratedScript script) {
    return script.text().lines().map(String::strip).toList();
  }

  private static long count(GeneratedScript script, String line) {
    return lines(script).stream().filter(line::equals).count();
  }

  @Test
  void untilSomebodyHasBeenAskedThereIsARemark() {
    assertEquals(
        """
        $ 2 "External Control"
        # begin: URCap node FZI: External Control
        # the script that 192.168.56.1:50002 is asked for when the program starts
        # end: URCap node FZI: External Control
        """,
        body(control()));
  }

  @Test
  void theHeaderStandsBeforeTheProgramAndTheLoopInPlaceOfTheNode() {
    List<String> script = lines(generated(program(control())));
    int header = script.indexOf("# HEADER_BEGIN");
    int main = script.indexOf("$ 1 \"Robot Program\"");
    assertTrue(0 < header && header < main, script::toString);
    assertEquals(
        List.of(
            "$ 2 \"External Control\"",
            "# begin: URCap node FZI: External Control",
            "",
            "# NODE_CONTROL_LOOP_BEGINS",
            "control()",
            "# end: URCap node FZI: External Control"),
        script.subList(main + 1, main + 7));
  }

  @Test
  void severalNodesHaveOneHeader() {
    GeneratedScript script = generated(program(control(), control()));
    assertEquals(1, count(script, "def control():"));
    assertEquals(2, count(script, "control()"));
  }

  @Test
  void nodesInThreadsAndSubProgramsFindTheHeader() {
    List<String> script =
        lines(generated(tree(once(), node(new Section.ThreadSection("Beside", true), control()))));
    assertTrue(script.indexOf("def control():") < script.indexOf("thread Beside():"));
  }

  @Test
  void linesThatWereReceivedAreKnownByTheirNumbersThere() {
    GeneratedScript script = generated(program(control(), control()));
    List<String> lines = script.text().lines().map(String::strip).toList();
    int[] numbers =
        IntStream.rangeClosed(1, lines.size())
            .filter(each -> lines.get(each - 1).equals("control()"))
            .map(each -> script.receivedLine(each).orElse(0))
            .toArray();
    assertEquals(List.of(8, 8), IntStream.of(numbers).boxed().toList());
    assertEquals(OptionalInt.of(2), script.receivedLine(lines.indexOf("def control():") + 1));
    assertEquals(OptionalInt.empty(), script.receivedLine(1));
    assertEquals(OptionalInt.empty(), script.receivedLine(lines.size()));
  }

  @Test
  void aStubRunsInPlaceOfWhatADriverWouldSend() {
    ForeignStep.Contributed stubbed =
        new ForeignStep.Contributed("FZI", ExternalControl.TYPE, List.of(), List.of("sync()"));
    assertFalse(ExternalControl.is(stubbed));
    assertEquals(0, ExternalControl.count(program(node(stubbed))));
    assertTrue(body(node(stubbed)).contains("sync()\n"));
  }

  @Test
  void suppressedNodesDoNotCount() {
    ProgramNode off = control().withSuppressed(true);
    assertEquals(1, ExternalControl.count(program(off, control())));
    assertEquals(
        0,
        ExternalControl.count(
            tree(node(new Section.MainProgram(false), control()).withSuppressed(true))));
  }
}
