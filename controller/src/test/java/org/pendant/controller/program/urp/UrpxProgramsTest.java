package org.pendant.controller.program.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.packedxml.UnreadableFile;
import org.pendant.controller.program.ActionStep;
import org.pendant.controller.program.ProgramNode;
import org.pendant.controller.program.Section;

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
