package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.project.polyscope.xml.PackedXml;

/** Program trees on the command line: run, check and convert. */
@Tag("slow")
class TreeProgramsTest {
  private static final String URP =
      "<URProgram name=\"pick\" installation=\"cell\"><children><MainProgram runOnlyOnce=\"true\">"
          + "<children>%s</children></MainProgram></children></URProgram>";
  private static final String SAY =
      "<Script type=\"Code\"><cachedContents>textmsg(get_tcp_offset())</cachedContents></Script>";
  private static final String CELL =
      "<Installation><TCPSettings activePose=\"Grip\"><availablePoses><tcp name=\"Grip\""
          + " offset=\"0, 0, 0.1, 0, 0, 0\"/></availablePoses></TCPSettings>"
          + "<IOs><DigitalOutputNames value=\", Lamp\"/></IOs></Installation>";
  private static final String OWN =
      """
      pendant program 1
      main
        script-line code="textmsg(1)"
      """;

  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  private String file(String name) {
    return folder.resolve(name).toString();
  }

  private void write(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private String text(String name) throws IOException {
    return Files.readString(folder.resolve(name));
  }

  /** Answers the exit code; words that are files stand in the folder of the test. */
  private int pendant(String... words) {
    output.reset();
    errors.reset();
    List<String> all = new ArrayList<>();
    for (String each : words) {
      all.add(each.contains(".") && !each.startsWith("-") ? file(each) : each);
    }
    return new Pendant(new Console(output, errors)).run(all).number();
  }

  private String said() {
    return output.toString(StandardCharsets.UTF_8);
  }

  /** Complaints without the folder of the test. */
  private List<String> complaints() {
    return errors.toString(StandardCharsets.UTF_8).replace(folder + "/", "").lines().toList();
  }

  @Test
  void runsAUrpInTheInstallationThatItNames() throws IOException {
    Files.write(folder.resolve("pick.urp"), PackedXml.packed(URP.formatted(SAY)));
    write("cell.installation", CELL);
    assertEquals(0, pendant("run", "pick.urp"));
    assertEquals("p[0, 0, 0.1, 0, 0, 0]\n", said());
    assertEquals(List.of(), complaints());
  }

  @Test
  void tellsThatTheInstallationIsNotThere() throws IOException {
    write("pick.urp", URP.formatted(SAY));
    assertEquals(0, pendant("run", "pick.urp"));
    assertEquals("p[0, 0, 0, 0, 0, 0]\n", said());
    assertEquals(
        List.of("pick.urp: note: its installation cell is not there, none is used"), complaints());
  }

  @Test
  void theInstallationOfTheCommandLineCounts() throws IOException {
    write("pick.urp", URP.formatted(SAY));
    write("other.installation", CELL.replace("0.1", "0.2"));
    write("cell.installation", CELL);
    assertEquals(0, pendant("run", "--installation", "other.installation", "pick.urp"));
    assertEquals("p[0, 0, 0.2, 0, 0, 0]\n", said());
  }

  @Test
  void runsAUrpOnTheArmThatItWasMadeOn() throws IOException {
    String reach = URP.formatted(SAY.replace("get_tcp_offset()", "get_forward_kin([0,0,0,0,0,0])"));
    write("any.urp", reach);
    write(
        "large.urp",
        reach.replace(
            "<children><MainProgram",
            """
            <kinematics status="NOT_INITIALIZED">
              <deltaTheta value="0, 0, 0, 0, 0, 0"/>
              <a value="0, -0.6127, -0.57155, 0, 0, 0"/>
              <d value="0.1807, 0, 0, 0.17415, 0.11985, 0.11655"/>
              <alpha value="1.570796327, 0, 0, 1.570796327, -1.570796327, 0"/>
            </kinematics>
            <children><MainProgram\
            """));
    write("cell.installation", CELL);
    assertEquals(0, pendant("run", "any.urp"));
    String usual = said();
    assertEquals(0, pendant("run", "--robot", "ur10e", "any.urp"));
    String large = said();
    assertEquals(0, pendant("run", "large.urp"));
    assertEquals(large, said());
    assertEquals(
        List.of("large.urp: note: line 1, URProgram: it was made on a ur10e"), complaints());
    assertEquals(0, pendant("run", "--robot", "ur5e", "large.urp"));
    assertEquals(usual, said());
  }

  @Test
  void runsTheScriptInAUrpxAndWritesNone() throws IOException {
    write(
        "say.urpx",
        """
        {"application": {"urscript": {"script": "x = 3"}},
         "program": {"programContent": {"contributedNode": {"type": "ur-program"}},
           "urscript": {"script": "textmsg(x)"}}}
        """);
    assertEquals(0, pendant("run", "say.urpx"));
    assertEquals("3\n", said());
    assertEquals(0, pendant("convert", "say.urpx", "say.pendant"));
    assertEquals(0, pendant("run", "say.pendant"));
    assertEquals("3\n", said());
    assertEquals(2, pendant("convert", "say.pendant", "other.urpx"));
  }

  @Test
  void namesTheNodeOfAUrpxWhereItFails() throws IOException {
    write(
        "index.urpx",
        """
        {"application": {"urscript": {"script": "x = 3"}},
         "program": {"programContent": {"guid": "a", "contributedNode": {"type": "ur-program"},
             "children": [{"guid": "b", "contributedNode": {"type": "ur-assign"}}]},
           "urscript": {"script": "$ 1 \\"ur-assign\\"\\ny = [1, 2][norm(5)]",
             "nodeIDList": ["", "b"]}}}
        """);
    assertEquals(1, pendant("run", "index.urpx"));
    List<String> complaints = complaints();
    assertTrue(
        complaints.stream().anyMatch(each -> each.startsWith("index.urpx: node 3 \"ur-assign\"")),
        complaints::toString);
  }

  @Test
  void runsProgramsOfOurOwnForm() throws IOException {
    write("say.pendant", OWN);
    assertEquals(0, pendant("run", "say.pendant"));
    assertEquals("1\n", said());
    assertEquals(0, pendant("check", "say.pendant"));
  }

  @Test
  void namesTheNodeWhereAProgramFails() throws IOException {
    write("index.pendant", OWN.replace("textmsg(1)", "textmsg([1, 2][norm(5)])"));
    assertEquals(1, pendant("run", "index.pendant"));
    List<String> complaints = complaints();
    assertTrue(complaints.getFirst().startsWith("index.pendant.script:"), complaints::toString);
    assertTrue(
        complaints.stream()
            .anyMatch(
                each ->
                    each.startsWith("index.pendant: node 2 \"textmsg([1, 2][norm(5)])\": index")),
        complaints::toString);
  }

  private static final String CONTROL =
      "<Contributed strategyProgramNodeType=\"External Control\"><dataModel/></Contributed>";

  private static final String SENT =
      """
      # HEADER_BEGIN
      def greet(name):
        textmsg(name)
      end
      # HEADER_END
      greet("driver")
      """;

  @Test
  void runsWhatADriverSendsForExternalControl() throws IOException {
    write("drive.urp", URP.formatted(CONTROL));
    write("cell.pinst", "pendant installation 1\n");
    try (FakeDriver driver = new FakeDriver(SENT)) {
      assertEquals(0, pendant("check", "drive.urp"));
      assertEquals(List.of(), complaints());
      assertEquals(0, driver.asked());
      String option = "--external-control=" + driver.host().text();
      assertEquals(0, pendant("run", option, "drive.urp"));
      assertEquals("driver\n", said());
      assertEquals(List.of(), complaints());
      write(
          "cell.pinst",
          "pendant installation 1\nexternal-control host=\"127.0.0.1\" port="
              + driver.host().port()
              + "\n");
      assertEquals(0, pendant("run", "drive.urp"));
      assertEquals("driver\n", said());
      assertEquals(2, driver.asked());
    }
  }

  @Test
  void doesNotRunWithoutTheDriver() throws IOException {
    write("drive.urp", URP.formatted(CONTROL));
    write("cell.pinst", "pendant installation 1\n");
    FakeDriver gone = new FakeDriver("");
    gone.close();
    assertEquals(69, pendant("run", "--external-control=" + gone.host().text(), "drive.urp"));
    assertEquals(
        List.of(
            "drive.urp: error: External Control: nobody answers at "
                + gone.host().text()
                + " (connection refused); the driver must be running"),
        complaints());
    assertEquals(69, pendant("run", "--allow-hosts=none", "drive.urp"));
    assertEquals(
        List.of(
            "drive.urp: error: External Control: 192.168.56.1:50002 is not among the allowed"
                + " hosts"),
        complaints());
    assertEquals(2, pendant("run", "--external-control=pc:0", "drive.urp"));
    assertEquals(
        List.of("pendant run: --external-control: the port is 0, must be 1 to 65535"),
        complaints().subList(0, 1));
  }

  @Test
  void tellsTheLineOfWhatADriverHasSent() throws IOException {
    write("drive.urp", URP.formatted(CONTROL));
    write("cell.pinst", "pendant installation 1\n");
    try (FakeDriver driver = new FakeDriver(SENT.replace("textmsg(name)", "textmsg(nam)"))) {
      assertEquals(1, pendant("run", "--external-control=" + driver.host().text(), "drive.urp"));
      String place = "line 3 of the script from " + driver.host().text() + ": ";
      assertTrue(
          complaints().stream().anyMatch(each -> each.startsWith("drive.urp: " + place)),
          () -> complaints().toString());
    }
    try (FakeDriver driver = new FakeDriver(SENT.replace("textmsg(name)", "textmsg(name"))) {
      assertEquals(3, pendant("run", "--external-control=" + driver.host().text(), "drive.urp"));
      String place = "line 4 of the script from " + driver.host().text() + ": ";
      assertTrue(
          complaints().stream().anyMatch(each -> each.startsWith("drive.urp: " + place)),
          () -> complaints().toString());
    }
  }

  @Test
  void saysThatAScriptDoesNotHoldWhatADriverSends() throws IOException {
    write("drive.urp", URP.formatted(CONTROL));
    write("cell.pinst", "pendant installation 1\n");
    assertEquals(0, pendant("convert", "drive.urp", "drive.script"));
    assertEquals(
        List.of(
            "drive.script: note: what External Control nodes do is not in it: a driver sends that"
                + " when the program starts"),
        complaints());
  }

  @Test
  void listsWhatKeepsAProgramFromRunning() throws IOException {
    write(
        "open.pendant",
        """
        pendant program 1
        main
          move kind=joint speed=1 acceleration=1 feature="Base"

            waypoint target=fixed name="Above"
          halt
          if
            halt
        """);
    for (String command : List.of("run", "check")) {
      assertEquals(3, pendant(command, "open.pendant"));
      List<String> complaints = complaints();
      assertEquals(2, complaints.size(), complaints::toString);
      assertTrue(complaints.get(0).startsWith("open.pendant:5: error: "), complaints::toString);
      assertTrue(complaints.get(1).startsWith("open.pendant:7: error: "), complaints::toString);
    }
    assertEquals(3, pendant("convert", "open.pendant", "open.script"));
    assertFalse(Files.exists(folder.resolve("open.script")));
  }

  @Test
  void tellsWhereAFileCannotBeRead() throws IOException {
    write("broken.pendant", "pendant program 1\nmain\n  jump\n");
    write("broken.urp", "<URProgram>\n<children>");
    for (String command : List.of("run", "check")) {
      assertEquals(3, pendant(command, "broken.pendant", "broken.urp"));
      assertTrue(
          complaints().getFirst().startsWith("broken.pendant:3:3: error: "),
          () -> complaints().toString());
      assertTrue(complaints().getLast().startsWith("broken.urp:2:"), () -> complaints().toString());
    }
    assertEquals(3, pendant("convert", "broken.urp", "broken2.pendant"));
    assertEquals(2, pendant("run", "missing.urp"));
  }

  @Test
  void runsTheScriptBesideAUrpWithUnknownNodes() throws IOException {
    write("weld.urp", URP.formatted("<Weld/>"));
    write("weld.script", "def weld():\n  textmsg(\"saved\")\nend\n");
    assertEquals(0, pendant("run", "weld.urp"));
    assertEquals("saved\n", said());
    assertTrue(
        complaints().getLast().endsWith("weld.script runs in its place, which was saved beside it"),
        () -> complaints().toString());
    Files.delete(folder.resolve("weld.script"));
    assertEquals(0, pendant("run", "weld.urp"));
    assertEquals("", said());
  }

  @Test
  void convertsProgramsBetweenAllForms() throws IOException {
    write(
        "pick.urp",
        URP.formatted(
            SAY
                + "<Set type=\"DigitalOutput\"><pin referencedName=\"Lamp\"/>"
                + "<digitalValue>1</digitalValue></Set><Weld  a='1'/>"));
    write("cell.installation", CELL);
    assertEquals(0, pendant("convert", "pick.urp", "pick.pendant"));
    String text = text("pick.pendant");
    assertTrue(text.contains("set setting=digital signal=\"digital_out[1]\" level=true"), text);
    assertTrue(text.contains("| <Weld  a='1'/>"), text);
    assertEquals(0, pendant("convert", "pick.pendant", "again.urp"));
    assertTrue(
        complaints().getFirst().startsWith("again.urp: note: writing .urp is experimental"),
        () -> complaints().toString());
    assertEquals(0, pendant("convert", "again.urp", "again.pendant"));
    assertEquals(text, text("again.pendant"));
    assertEquals(0, pendant("convert", "pick.urp", "pick.script"));
    assertTrue(text("pick.script").startsWith("def pick():\n  set_tcp(p[0.0, 0.0, 0.1"));
    assertEquals(0, pendant("run", "pick.script"));
    assertEquals("p[0, 0, 0.1, 0, 0, 0]\n", said());
  }

  @Test
  void tellsWhichNodesNoRobotKnows() throws IOException {
    write("ask.pendant", OWN + "  operator-input variable=\"n\" kind=integer message=\"How?\"\n");
    assertEquals(0, pendant("convert", "ask.pendant", "ask.urp"));
    assertEquals(
        "ask.urp: note: node 3, Operator input is written in a form of Pendant's own, which no"
            + " robot knows",
        complaints().getLast());
  }

  @Test
  void convertsInstallationsAndRecordings() throws IOException {
    write("cell.installation", CELL.replace("</IOs>", "</IOs><Fieldbus/>"));
    write("cell.variables", "count=3\n");
    assertEquals(0, pendant("convert", "cell.installation", "cell.pinst"));
    assertEquals(
        List.of("cell.installation: note: not understood, and as in a new installation: Fieldbus"),
        complaints());
    assertTrue(text("cell.pinst").contains("tool name=\"Grip\""), text("cell.pinst"));
    assertTrue(text("cell.pinst").contains("count"), text("cell.pinst"));
    write("say.pendant", OWN);
    assertEquals(0, pendant("run", "--record", "out.rec", "say.pendant"));
    assertEquals(0, pendant("convert", "out.rec", "out.csv"));
    assertTrue(text("out.csv").startsWith("time_s,target_q_0,"), text("out.csv"));
  }

  @Test
  void overwritesNothingUnlessForced() throws IOException {
    write("say.pendant", OWN);
    write("say.script", "keep me");
    assertEquals(2, pendant("convert", "say.pendant", "say.script"));
    assertEquals(
        "pendant convert: say.script exists already, --force replaces it", complaints().getFirst());
    assertEquals("keep me", text("say.script"));
    assertEquals(0, pendant("convert", "--force", "say.pendant", "say.script"));
    assertTrue(text("say.script").startsWith("def say():"));
  }

  @Test
  void refusesConversionsThatThereAreNot() throws IOException {
    write("say.script", "textmsg(1)");
    assertEquals(2, pendant("convert", "say.script", "say.urp"));
    assertTrue(
        complaints()
            .getFirst()
            .contains("say.script cannot become say.urp: .urp, .urpx and .pendant"),
        () -> complaints().toString());
    assertEquals(2, pendant("convert", "say.script"));
    assertEquals(2, pendant("convert", "missing.urp", "missing.pendant"));
    assertEquals(2, pendant("convert", "missing.rec", "missing.csv"));
  }
}
