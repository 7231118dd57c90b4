package org.pendant.controller.installation.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.installation.BaseMounting;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.NamedTool;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.packedxml.PackedXml;
import org.pendant.controller.packedxml.UnreadableFile;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

class UrInstallationsTest {
  private static final String CELL =
      """
      <Installation>
        <Version major="5" minor="24" bugfix="1"/>
        <TCPSettings activePose="Grip">
          <availablePoses>
            <tcp id="1" name="Grip" offset="0.0, 0.0, 0.15, 0.0, 0.0, 1.0"/>
            <tcp id="2" name="Broken" offset="0.0, 0.0"/>
          </availablePoses>
        </TCPSettings>
        <SafetySettings>
      [SafetyLimits Normal Values]
      maxTcpSpeed = 1.5
        </SafetySettings>
        <SafeHomeSettings enabled="true" position="0.0, -1.5, -1.5, -1.5, 1.5, 0.5"/>
        <Features><CameraView><worldTransform>
          <WorldtoMarshal baseAngle="0.3" tiltAngle="1.2"/>
        </worldTransform></CameraView></Features>
        <PayloadSettings>
          <Payload name="Empty" mass="0.5" defaultPayload="false" centerOfGravity="0, 0, 0"/>
          <Payload name="Grip" mass="1.2" defaultPayload="true" centerOfGravity="0, 0.01, 0.05"/>
        </PayloadSettings>
        <IOs>
          <DigitalInputNames value=", Part here, , , , , , "/>
          <ConfigurableOutputNames value="Lamp, , , , , , , "/>
          <ToolDigitalInputNames value="a, b, beyond"/>
        </IOs>
      </Installation>
      """;

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  @Test
  void readsWhatIsKnownOfTheForm() throws UnreadableFile {
    Installation cell = UrInstallations.read(bytes(CELL)).installation();
    assertEquals(List.of(new NamedTool("Grip", new Pose(0, 0, 0.15, 0, 0, 1))), cell.tools());
    assertEquals("Grip", cell.activeTool());
    assertEquals(
        List.of(
            new NamedPayload("Empty", 0.5, new Vector3(0, 0, 0), Inertia.NONE),
            new NamedPayload("Grip", 1.2, new Vector3(0, 0.01, 0.05), Inertia.NONE)),
        cell.payloads());
    assertEquals("Grip", cell.activePayload());
    assertEquals(new BaseMounting(1.2, 0.3), cell.mounting());
    assertEquals(new Joints(0, -1.5, -1.5, -1.5, 1.5, 0.5), cell.homeRad());
    assertEquals(
        List.of(
            "digital_in[1] Part here", "configurable_out[0] Lamp", "tool_in[0] a", "tool_in[1] b"),
        cell.signals().stream().map(UrInstallationsTest::named).toList());
  }

  private static String named(SignalUse use) {
    return use.signal() + " " + use.name();
  }

  @Test
  void readsCompressedFiles() throws UnreadableFile {
    assertEquals(UrInstallations.read(bytes(CELL)), UrInstallations.read(PackedXml.packed(CELL)));
  }

  @Test
  void tellsWhatItDoesNotUnderstand() throws UnreadableFile {
    assertEquals(
        List.of(
            "line 6: this TCP has no name or no offset of six numbers",
            "line 14: features are not understood, apart from how the base is mounted; programs"
                + " bring those that they use",
            "not understood, and as in a new installation: SafetySettings"),
        UrInstallations.read(bytes(CELL)).remarks());
  }

  @Test
  void readsTheOnlyPayloadOfOlderFiles() throws UnreadableFile {
    String older =
        "<Installation><TCPSettingsImpl activePose=\"T\" toolPayload=\"2.5\""
            + " toolPayloadCenterOfGravity=\"0.01, 0.02, 0.1\"/></Installation>";
    Installation read = UrInstallations.read(bytes(older)).installation();
    assertEquals(
        List.of(new NamedPayload("Payload", 2.5, new Vector3(0.01, 0.02, 0.1), Inertia.NONE)),
        read.payloads());
    assertEquals("Payload", read.activePayload());
    assertEquals("", read.activeTool());
  }

  @Test
  void refusesOtherFiles() {
    UnreadableFile refused =
        assertThrows(UnreadableFile.class, () -> UrInstallations.read(bytes("<URProgram/>")));
    assertEquals("x:1:1: error: holds a URProgram, must hold a Installation", refused.report("x"));
    assertTrue(
        assertThrows(UnreadableFile.class, () -> UrInstallations.read(bytes("x = 1")))
            .report("x")
            .startsWith("x:1:1: error: is no XML: "));
  }

  @Test
  void readsVariablesOfEitherForm() throws UnreadableFile {
    List<InstallationVariable> variables =
        List.of(
            new InstallationVariable("count", "3", true),
            new InstallationVariable("spot", "p[0, 0, 0, 0, 0, 0]", false));
    assertEquals(
        variables,
        UrInstallations.variables(
            PackedXml.packed(
                """
                <InstallationVariables timestamp="1">
                  <variable name="count" value="3" favourite="true"/>
                  <variable><name>spot</name><value>p[0, 0, 0, 0, 0, 0]</value></variable>
                </InstallationVariables>
                """)));
    assertEquals(
        List.of(new InstallationVariable("count", "3", false), variables.getLast()),
        UrInstallations.variables(bytes("#saved\ncount=3\nspot = p[0, 0, 0, 0, 0, 0]\n")));
  }

  @Test
  void refusesVariablesWithoutNames() {
    assertEquals(
        "v:1:24: error: has no name",
        assertThrows(
                UnreadableFile.class,
                () ->
                    UrInstallations.variables(
                        bytes(
                            "<InstallationVariables><variable value=\"3\"/>"
                                + "</InstallationVariables>")))
            .report("v"));
  }
}
