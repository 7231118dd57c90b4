package org.pendant.project.program.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.installation.Installation;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.StepNames;
import org.pendant.project.program.check.ProgramCheck;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.ScriptGenerator;

class UrpxProgramsTest {
  private static final String WAIT =
      """
      {"application": {"id": "5", "urscript": {
          "script": "def f(x):\\n  return x\\nend\\nset_tool_voltage(f(0)) # g(1)\\n"},
        "applicationInfo": {"name": null}},
       "program": {
        "programContent": {
          "contributedNode": {"type": "ur-program"},
          "children": [{
            "contributedNode": {"type": "ur-wait", "parameters": {"time": {"value": 2}}},
            "programLabel": [{"type": "secondary", "value": "2.00 s"}],
            "children": []}]},
        "urscript": {"script": "$ 1 \\"ur-program\\"\\n$ 2 \\"ur-wait\\"\\nsleep(2)", "nodeIDList": []}}}
      """;

  /** A loop with a wait in it, and a node that has become nothing. */
  private static final String LOOP =
      """
      {"application": {"urscript": {"script": "$ 1 \\"other\\"\\nx = 1"}},
       "program": {
        "programContent": {"guid": "a", "contributedNode": {"type": "ur-program"}, "children": [
          {"guid": "b", "contributedNode": {"type": "ur-status"}},
          {"guid": "c", "contributedNode": {"type": "ur-code"}, "children": [
            {"guid": "d", "contributedNode": {"type": "ur-wait"}},
            {"guid": "e", "contributedNode": {"type": "ur-halt"}}]},
          {"guid": "f", "contributedNode": {"type": "ur-empty"}}]},
        "urscript": {"nodeIDList": ["0", "a", "c", "d", "e", "f"], "script":
          "$ 1 \\"ur-program\\"\\n$ 2 \\"ur-code\\"\\nwhile (True):\\n  $ 3 \\"ur-wait\\"\\n  # 2 s\\n  sleep(2)\\n\\n  x = 2\\n  $ 4 \\"ur-halt\\"\\n  halt\\nend\\n$ 5 \\"ur-empty\\"\\n$ 9 \\"ur-none\\""}}}
      """;

  private static ImportedProgram read(String json) throws UnreadableFile {
    return UrpxPrograms.read("wait.urpx", json.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void runsTheScriptOfAProgramAndShowsItsNodes() throws UnreadableFile {
    ImportedProgram program = read(WAIT);
    assertEquals("wait", program.name());
    ProgramNode main = program.tree().sections().getFirst();
    assertEquals(new Section.MainProgram(false), main.step());
    ProgramNode shown = main.children().getFirst();
    assertTrue(shown.suppressed());
    assertEquals(new ActionStep.Folder("ur-program"), shown.step());
    assertEquals(new ActionStep.Folder("ur-wait 2.00 s"), shown.children().getFirst().step());
    assertEquals(
        new ActionStep.ScriptFile(
            "wait.urpx",
            List.of("def f(x):", "  return x", "end", "set_tool_voltage(f(0)) # g(1)")),
        main.children().get(1).step());
    assertEquals(
        new ActionStep.ScriptFile(
            "wait.urpx", List.of("# 1 \"ur-program\"", "# 2 \"ur-wait\"", "sleep(2)")),
        main.children().getLast().step());
    assertEquals(
        List.of(false, false),
        main.children().stream().skip(1).map(ProgramNode::suppressed).toList());
    assertEquals(
        List.of("the nodes of PolyScope X are only shown; the script that they have become runs"),
        program.remarks());
  }

  @Test
  void remarksInTheScriptNameTheNodesOfTheTree() throws UnreadableFile {
    ProgramNode code = read(LOOP).tree().sections().getFirst().children().getLast();
    assertEquals(
        new ActionStep.ScriptFile(
            "wait.urpx",
            List.of(
                "# node 2 \"ur-program\"",
                "# node 4 \"ur-code\"",
                "while (True):",
                "  # node 5 \"ur-wait\"",
                "  # 2 s",
                "  sleep(2)",
                "",
                "  x = 2",
                "  # node 6 \"ur-halt\"",
                "  halt",
                "end",
                "# node 7 \"ur-empty\"",
                "# 9 \"ur-none\"")),
        code.step());
  }

  @Test
  void theLinesOfTheScriptBelongToTheNodesThatAreShown() throws UnreadableFile {
    ProgramTree tree = read(LOOP).tree().renumbered();
    GeneratedScript own = ScriptGenerator.generate("wait", tree, Installation.NONE);
    GeneratedScript script = ShownNodes.placed(tree, own);
    assertEquals(own.text(), script.text());
    List<String> lines = script.text().lines().toList();
    List<String> found =
        tree.nodes().stream()
            .filter(node -> ShownNodes.isShown(tree, node.key()))
            .map(
                node ->
                    StepNames.label(node)
                        + script
                            .of(node.key())
                            .map(
                                at ->
                                    ": "
                                        + lines.get(at.first() - 1).strip()
                                        + " .. "
                                        + lines.get(at.last() - 1).strip())
                            .orElse(""))
            .toList();
    assertEquals(
        List.of(
            "ur-program: while (True): .. # 9 \"ur-none\"",
            "ur-status",
            "ur-code: while (True): .. end",
            "ur-wait: sleep(2) .. x = 2",
            "ur-halt: halt .. halt",
            "ur-empty: # node 7 \"ur-empty\" .. # 9 \"ur-none\""),
        found);
    int sleep = lines.indexOf("  " + "  sleep(2)") + 1;
    assertEquals(5, script.at(sleep).orElseThrow().number());
    assertEquals(5, script.at(sleep + 2).orElseThrow().number());
    int end = lines.indexOf("  end") + 1;
    assertEquals(4, script.at(end).orElseThrow().number());
  }

  @Test
  void remarksOfOthersMoveNoLines() throws UnreadableFile {
    String json = WAIT.replace("sleep(2)", "# node 77 \\\"x\\\"\\n# node x\\nsleep(2)");
    ProgramTree tree = read(json).tree().renumbered();
    GeneratedScript own = ScriptGenerator.generate("wait", tree, Installation.NONE);
    assertEquals(own, ShownNodes.placed(tree, own));
  }

  @Test
  void aScriptWithNothingInItIsNoNode() throws UnreadableFile {
    ProgramTree tree =
        read("""
        {"application": {"urscript": {"script": "\\n"}},
         "program": {"programContent": {}, "urscript": {"script": ""}}}
        """)
            .tree();
    assertEquals(1, tree.sections().getFirst().children().size());
    assertEquals(List.of(), ProgramCheck.problems(tree, Installation.NONE));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          "programInformation": {"name": "café 2"},      | café 2
          "programInformation": {"nam": "a"}, "x": 1,    | x: error: says no name: programInformation must have one
          "other": 1,                                    | x: error: is no program of PolyScope X: programInformation is missing, must be an object
          """)
  void tellsTheNameInAProgram(String information, String name) {
    String json =
        "{\"application\": {\"urscript\": {\"script\": \"\"}}, \"program\": {"
            + information
            + " \"programContent\": {}, \"urscript\": {\"script\": \"\"}}}";
    String said;
    try {
      said = UrpxPrograms.nameIn(json.getBytes(StandardCharsets.UTF_8));
    } catch (UnreadableFile e) {
      said = e.report("x");
    }
    assertEquals(name, said);
  }

  @Test
  void leavesOutASetUpThatNeedsOtherFunctions() throws UnreadableFile {
    ImportedProgram program = read(WAIT.replace("set_tool_voltage(", "reset_world_model("));
    assertTrue(program.tree().sections().getFirst().children().get(1).suppressed());
    assertEquals(
        "the script that sets up the robot is suppressed, as it needs functions of PolyScope X:"
            + " reset_world_model",
        program.remarks().getLast());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          []                 | x: error: is no program of PolyScope X: the file is missing, must be an object
          ``                 | x: error: is no program of PolyScope X: the file is missing, must be an object
          {"program": 1}     | x: error: is no program of PolyScope X: program is missing, must be an object
          {"program": {}, "application": {"urscript": {}}} | x: error: was saved without its script, so that nothing can run
          """)
  void refusesOtherFiles(String json, String message) {
    assertEquals(message, assertThrows(UnreadableFile.class, () -> read(json)).report("x"));
  }

  @Test
  void tellsWhereAFileIsNoJson() {
    String report =
        assertThrows(UnreadableFile.class, () -> read("{\n  \"program\": }")).report("x");
    assertTrue(report.startsWith("x:2:"), report);
    assertTrue(report.contains("error: is no JSON: "), report);
  }

  @Test
  void refusesNodesThatAreTooDeep() {
    String deep = "{\"children\": [".repeat(240) + "]}".repeat(240);
    String json =
        WAIT.replaceFirst(
            "(?s)\"programContent\": .*?\\]\\},", "\"programContent\": " + deep + ",");
    assertEquals(
        "x: error: nodes are more than 200 levels deep",
        assertThrows(UnreadableFile.class, () -> read(json)).report("x"));
  }
}
