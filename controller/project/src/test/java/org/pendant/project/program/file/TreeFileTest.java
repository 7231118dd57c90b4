package org.pendant.project.program.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.NamedTool;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.script.GeneratedScript;

class TreeFileTest {
  private static final String OWN =
      """
      pendant program 1
      installation file="cell"
      position name="P" tcp=[0, 0, 0, 0, 0, 0] feature="Base" joints-rad=[0, 0, 0, 0, 0, 0] tool-in-flange=[0, 0, 0, 0, 0, 0]
      initial-values
        - initial variable="n" expression="1"
      main
        script-file file="a.script"
          | n = 2

          | n = 3
        wait
        assignment variable="" expression="n +"
      """;
  private static final String URP =
      "<URProgram><children><MainProgram><children>%s</children></MainProgram></children>"
          + "</URProgram>";

  private static TreeFile read(String name, String text) throws BrokenTree {
    return TreeFile.read(name, text.getBytes(StandardCharsets.UTF_8));
  }

  private static List<String> refusal(String name, byte[] bytes) {
    return assertThrows(BrokenTree.class, () -> TreeFile.read(name, bytes)).reports();
  }

  @Test
  void tellsProblemsWithTheLinesOfTheirNodes() throws BrokenTree {
    TreeFile file = read("cells/a.pendant", OWN);
    assertEquals("a", file.programName());
    assertEquals("cell", file.tree().installation());
    List<String> problems = file.problems();
    assertFalse(problems.isEmpty());
    assertTrue(
        problems.stream().allMatch(each -> each.startsWith("cells/a.pendant:12: error: ")),
        problems::toString);
  }

  @Test
  void tellsProblemsOfAUrpWithTheNumbersOfTheirNodes() throws BrokenTree {
    TreeFile file = read("a.urp", URP.formatted("<Halt/><If type=\"If\"><expression/></If>"));
    assertTrue(
        file.problems().getFirst().startsWith("a.urp:3: error: condition: "),
        () -> file.problems().toString());
  }

  @Test
  void namesTheNodeOfALine() throws BrokenTree {
    TreeFile file =
        read("a.pendant", "pendant program 1\nmain\n  halt\n  wait what=time time-s=2\n");
    List<String> script = file.script().text().lines().toList();
    int line = 1;
    while (!script.get(line - 1).strip().startsWith("sleep(2")) {
      line++;
    }
    assertEquals(Optional.of("node 3 \"Wait: 2\""), file.nodeAt(line));
    assertEquals(Optional.empty(), file.nodeAt(1));
    assertEquals("a.pendant.script", file.scriptName());
  }

  @Test
  void knowsWhetherNodesDoNothing() throws BrokenTree {
    assertFalse(read("a.urp", URP.formatted("<Halt/>")).hasGaps());
    assertTrue(
        read("a.urp", URP.formatted("<Folder><children><Weld/></children></Folder>")).hasGaps());
    assertTrue(read("a.urp", URP.formatted("<Contributed/>")).hasGaps());
    assertFalse(read("a.urp", URP.formatted("<SuppressedNode><Weld/></SuppressedNode>")).hasGaps());
  }

  private static final String CONTROL =
      "<Contributed strategyProgramNodeType=\"External Control\"/>";

  @Test
  void waitsForTheScriptOfExternalControl() throws BrokenTree {
    TreeFile file =
        read("a.urp", URP.formatted(CONTROL + "<SuppressedNode>" + CONTROL + "</SuppressedNode>"));
    assertEquals(List.of(), file.remarks());
    assertEquals(List.of(), file.problems());
    assertFalse(file.hasGaps());
    assertEquals(1, file.waitingNodes());
    TreeFile whole = file.with(ControlScript.of(ControlHost.STANDARD, "sync()\nhalt\n"));
    assertEquals(0, whole.waitingNodes());
    GeneratedScript script = whole.script();
    int line = 1 + script.text().lines().map(String::strip).toList().indexOf("halt");
    assertEquals(
        Optional.of("line 2 of the script from 192.168.56.1:50002"),
        whole.receivedAt(script, line));
    assertEquals(Optional.empty(), whole.receivedAt(script, 1));
    assertEquals(1, whole.in(Installation.NONE).waitingNodes());
  }

  @Test
  void bringsFeaturesThatTheInstallationDoesNotKnow() throws BrokenTree {
    String move =
        "<Move motionType=\"MoveL\"><feature referencedName=\"%s\"/><children>"
            + "<Waypoint type=\"Fixed\" name=\"%1$s\"><position joints=\"0,0,0,0,0,0\"/>"
            + "<BaseToFeature pose=\"1, 2, 3, 0, 0, 0\"/></Waypoint></children></Move>";
    String text = URP.formatted(move.formatted("Table") + move.formatted("Belt"));
    Feature table =
        new Feature("Table", FeatureKind.POINT, List.of(new Pose(9, 9, 9, 0, 0, 0)), false, true);
    Installation cell = Installation.NONE.withFeatures(List.of(table));
    Installation both = read("a.urp", text).in(cell).installation();
    assertEquals(Optional.of(table), both.feature("Table"));
    assertEquals(List.of(new Pose(1, 2, 3, 0, 0, 0)), both.feature("Belt").orElseThrow().points());
  }

  @Test
  void bringsToolsThatTheInstallationDoesNotKnow() throws BrokenTree {
    String move =
        "<Move motionType=\"MoveL\" useActiveTCP=\"false\"><tcp referencedName=\"%s\"/><children>"
            + "<Waypoint type=\"Fixed\" name=\"%1$s\"><position>"
            + "<JointAngles angles=\"0,0,0,0,0,0\"/><TCPOffset pose=\"0, 0, 0.1, 0, 0, 0\"/>"
            + "</position></Waypoint></children></Move>";
    String text = URP.formatted(move.formatted("Grip") + move.formatted("Pen"));
    NamedTool grip = new NamedTool("Grip", new Pose(0, 0, 0.2, 0, 0, 0));
    Installation cell = Installation.NONE.withTools(List.of(grip));
    Installation both = read("a.urp", text).in(cell).installation();
    assertEquals(Optional.of(grip), both.tool("Grip"));
    assertEquals(new Pose(0, 0, 0.1, 0, 0, 0), both.tool("Pen").orElseThrow().inFlange());
  }

  @Test
  void refusesWhatIsNoTree() {
    assertTrue(
        refusal("x.pendant", "pendant program 1\nmain\n jump\n".getBytes(StandardCharsets.UTF_8))
            .getFirst()
            .startsWith("x.pendant:3:1: error: "));
    assertEquals(
        List.of("x.pendant: error: is no text in UTF-8"),
        refusal("x.pendant", new byte[] {(byte) 0xff}));
    assertEquals(
        List.of("x.urp:1:1: error: holds a a, must hold a URProgram"),
        refusal("x.urp", "<a/>".getBytes(StandardCharsets.UTF_8)));
    assertTrue(TreeFile.hasEnding("X.URP"));
    assertFalse(TreeFile.hasEnding("x.script"));
  }
}
