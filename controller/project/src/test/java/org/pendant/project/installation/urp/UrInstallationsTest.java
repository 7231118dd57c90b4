package org.pendant.project.installation.urp;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.installation.BaseMounting;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.NamedTool;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.installation.Wiring;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.polyscope.xml.PackedXml;
import org.pendant.project.polyscope.xml.UnreadableFile;

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
      maxTcpSpeed = 0.9
        </SafetySettings>
        <Profinet enabled="true"/>
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
    assertEquals(0.9, cell.safety().orElseThrow().normal().toolSpeedMPerS());
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
            "the normal limits lack maxPower, maxMomentum, maxStoppingTime, maxStoppingDistance,"
                + " maxForce, maxElbowSpeed, maxElbowForce, maxJointSpeed, minJointPosition with"
                + " minJointRevolutions, maxJointPosition with maxJointRevolutions; those of the"
                + " arm hold",
            "the reduced limits lack maxTcpSpeed; those of normal mode hold",
            "not understood, and as in a new installation: Profinet"),
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

  private static ImportedInstallation read(String elements) throws UnreadableFile {
    return UrInstallations.read(bytes("<Installation>" + elements + "</Installation>"));
  }

  @Test
  void readsTheCentreOfGravityOfOlderFiles() throws UnreadableFile {
    assertEquals(
        List.of(new NamedPayload("Payload", 1.1, new Vector3(0, 0, 0.05), Inertia.NONE)),
        read("<TCPSettings activePose=\"T\" toolPayload=\"1.1\" centerOfGravity=\"0, 0, 0.05\"/>")
            .installation()
            .payloads());
  }

  @Test
  void readsTheInertiaOfPayloads() throws UnreadableFile {
    String payload =
        "<PayloadSettings><Payload name=\"P\" mass=\"1\" defaultPayload=\"true\""
            + " centerOfGravity=\"0, 0, 0\" inertiaParameters=\"%s\"/></PayloadSettings>";
    assertEquals(
        new Inertia(0.1, 0.2, 0.3, 0, 0.01, 0.02),
        read(payload.formatted("0.1, 0.2, 0.3, 0.0, 0.01, 0.02"))
            .installation()
            .payloads()
            .getFirst()
            .inertia());
    ImportedInstallation refused = read(payload.formatted("-0.1, 0.2, 0.3, 0.0, 0.01, 0.02"));
    assertEquals(Inertia.NONE, refused.installation().payloads().getFirst().inertia());
    assertEquals(
        List.of(
            "line 1: the inertia of this payload is left out: the first three must not be"
                + " negative"),
        refused.remarks());
  }

  @Test
  void readsWhatAnalogSignalsAreMadeOf() throws UnreadableFile {
    Wiring wiring =
        read("<IOs><analogInputRange value=\"0, 1, 1, 0\"/><analogOutputDomain value=\"1,"
                + " 0\"/></IOs>")
            .installation()
            .wiring();
    assertEquals(List.of(AnalogDomain.CURRENT, AnalogDomain.VOLTAGE), wiring.analogIn());
    assertEquals(List.of(AnalogDomain.VOLTAGE, AnalogDomain.CURRENT), wiring.analogOut());
    assertEquals(List.of(AnalogDomain.VOLTAGE, AnalogDomain.CURRENT), wiring.toolAnalogIn());
  }

  @Test
  void readsTheToolConnector() throws UnreadableFile {
    ImportedInstallation read =
        read(
            """
            <ToolCommSettings enabled="true" toolAnalogInput2="CURRENT" toolAnalogInput3="VOLTAGE"
                baudRate="BAUD_57600" parity="EVEN" stopBits="TWO" rxIdleChars="2.5"
                txIdleChars="4.5" toolOutputMode="OUTPUT" toolDigitalOutput0="SOURCING"
                toolDigitalOutput1="SINKING" toolOutputVoltage="TWENTY_FOUR"/>
            <SmoothTransitionSettings transitionHardness="HARD"/>
            """);
    Wiring wiring = read.installation().wiring();
    assertEquals(List.of(AnalogDomain.CURRENT, AnalogDomain.VOLTAGE), wiring.toolAnalogIn());
    assertEquals(24, wiring.toolVoltage());
    assertEquals(ToolOutputMode.DIGITAL, wiring.toolOutputMode());
    assertEquals(List.of(ToolPinMode.SOURCING, ToolPinMode.SINKING), wiring.toolPins());
    assertEquals(
        new ToolCommunication(true, 57600, ToolCommunication.Parity.EVEN, 2, 2.5f, 4.5f),
        wiring.toolCommunication());
    assertEquals(0, read.installation().transitionHardness());
    assertEquals(List.of(), read.remarks());
    assertEquals(
        List.of("toolOutputVoltage=\"SIX\" is not understood; it is 0 V"),
        read("<ToolCommSettings toolOutputVoltage=\"SIX\"/>").remarks());
  }

  @Test
  void readsWhatSignalsDoByThemselves() throws UnreadableFile {
    ImportedInstallation read =
        read(
            """
            <IOs>
              <DigitalOutputNames value="Lamp, "/>
              <DigitalOutputActions value="NONE, LOW_WHEN_PROGRAM_STOPPED"/>
              <ToolDigitalInputActions value="FREEDRIVE, STOP"/>
              <GeneralPurposeIntRegisterInputNames value=", order"/>
            </IOs>
            """);
    assertEquals(
        List.of(
            new SignalUse("digital_out[0]", "Lamp", InputAction.DEFAULT, RunStateAction.PRESERVE),
            new SignalUse(
                "digital_out[1]", "", InputAction.DEFAULT, RunStateAction.LOW_WHEN_NOT_RUNNING),
            new SignalUse("tool_in[0]", "", InputAction.FREEDRIVE, RunStateAction.PRESERVE),
            new SignalUse(
                "input_integer_register[1]",
                "order",
                InputAction.DEFAULT,
                RunStateAction.PRESERVE)),
        read.installation().signals());
    assertEquals(
        List.of("the action STOP of tool_in[1] is not understood; it has none"), read.remarks());
  }

  @Test
  void keepsTwoSignalsOfOneName() throws UnreadableFile {
    ImportedInstallation read =
        read("<IOs><ConfigurableInputNames value=\"S-Guard, S-Guard\"/></IOs>");
    assertEquals(
        List.of("configurable_in[0] S-Guard", "configurable_in[1] S-Guard"),
        read.installation().signals().stream().map(UrInstallationsTest::named).toList());
    assertEquals(
        List.of("configurable_in[1] is called S-Guard as well; the name means the first of them"),
        read.remarks());
    assertEquals(
        Optional.empty(), InstallationCheck.refusal(read.installation(), ArmLibrary.load("ur5e")));
  }

  @Test
  void readsSignalsOfModbusDevices() throws UnreadableFile {
    ImportedInstallation read =
        read(
            """
            <IOs><ModbusUnits>
              <Unit sequentialMode="false" ipAddress="192.168.0.3">
                <ModbusSignal name="RearPlc" type="DIGITAL_INPUT" signalAddress="8195"
                    slaveAddress="255" updateFrequency="10" inputAction="NONE"/>
                <ModbusSignal name="speed" type="REGISTER_OUTPUT" signalAddress="270"
                    slaveAddress="1" updateFrequency="20" outputAction="LOW"/>
                <ModbusSignal name="broken"/>
              </Unit></ModbusUnits></IOs>
            """);
    assertEquals(
        List.of(
            new ModbusSetup("RearPlc", "192.168.0.3", 255, ModbusKind.DIGITAL_INPUT, 8195, 10),
            new ModbusSetup("speed", "192.168.0.3", 1, ModbusKind.REGISTER_OUTPUT, 270, 20)),
        read.installation().modbus());
    assertEquals(
        List.of(
            "the action LOW of the Modbus signal speed is left out",
            "line 7: this Modbus signal has no name, type, address or frequency"),
        read.remarks());
  }

  private static String point(String name, String at, String turned) {
    return "<GeomPoseNode name=\"%s\" isVariable=\"true\" joggable=\"false\" hiddenSubFeature=\"%s\">"
            .formatted(name, name.startsWith("hidden"))
        + "<jointPositionVector value=\"NaN, NaN, NaN, NaN, NaN, NaN\"/><toolPosition value=\""
        + at
        + "\"/><toolAxisAngle value=\""
        + turned
        + "\"/></GeomPoseNode>";
  }

  @Test
  void readsFeatures() throws UnreadableFile {
    // a plane upright on the y axis, and the frame that a robot has computed for it
    String plane =
        "<GeomPlaneNode><GeomPlaneNode name=\"left_edge\" isVariable=\"true\"><firstPoint>"
            + point("hidden_1", "0.0, -0.75, 0.0", "1.5, 0.0, 0.0")
            + "</firstPoint><secondPoint>"
            + point("hidden_2", "0.0, -0.75, 1.0", "1.5, 0.0, 0.0")
            + "</secondPoint><thirdPoint>"
            + point("hidden_3", "-1.0, -0.75, 0.5", "1.5, 0.0, 0.0")
            + "</thirdPoint></GeomPlaneNode></GeomPlaneNode>";
    ImportedInstallation read =
        read(
            "<Features><GeomPoseNode>"
                + point("Point_1", "0.1, 0.2, 0.3", "0.0, 3.1, 0.0")
                + "</GeomPoseNode>"
                + plane
                + "<GeomPoseNode>"
                + point("a-b", "0.1, 0.2, 0.3", "0.0, 3.1, 0.0")
                + "</GeomPoseNode></Features>");
    assertEquals(
        new Feature(
            "Point_1", FeatureKind.POINT, List.of(new Pose(0.1, 0.2, 0.3, 0, 3.1, 0)), true, false),
        read.installation().features().getFirst());
    Feature edge = read.installation().features().getLast();
    assertEquals("left_edge", edge.name());
    Pose frame = FeaturePoses.pose(edge).orElseThrow();
    assertEquals(
        0, Poses.distance(new Pose(0, -0.75, 0, Math.PI / 2, 0, 0), frame), 1e-9, frame::toString);
    assertEquals(0, Math.hypot(frame.ry(), frame.rz()), 1e-9);
    assertEquals(Math.PI / 2, frame.rx(), 1e-9);
    assertEquals(
        List.of("line 1: the feature a-b is left out, as its name is no name of the language"),
        read.remarks());
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.2, 0.2})
  void zOfAPlaneIsWhereTheToolPointedWhicheverSideTheThirdPointIsOn(double beside)
      throws UnreadableFile {
    ImportedInstallation read =
        read(
            "<Features><GeomPlaneNode><GeomPlaneNode name=\"table\""
                + " isVariable=\"true\"><firstPoint>"
                + point("hidden_1", "0.5, 0.1, 0.0", "3.141592653589793, 0.0, 0.0")
                + "</firstPoint><secondPoint>"
                + point("hidden_2", "0.9, 0.1, 0.0", "3.141592653589793, 0.0, 0.0")
                + "</secondPoint><thirdPoint>"
                + point("hidden_3", "0.6, " + (0.1 + beside) + ", 0.0", "0.0, 0.0, 0.0")
                + "</thirdPoint></GeomPlaneNode></GeomPlaneNode></Features>");
    Pose frame = FeaturePoses.pose(read.installation().features().getFirst()).orElseThrow();
    Pose y = Poses.trans(frame, new Pose(0, 1, 0, 0, 0, 0));
    Pose z = Poses.trans(frame, new Pose(0, 0, 1, 0, 0, 0));
    assertArrayEquals(new double[] {1.5, 0.1, 0}, new double[] {y.x(), y.y(), y.z()}, 1e-9);
    assertArrayEquals(new double[] {0.5, 0.1, -1}, new double[] {z.x(), z.y(), z.z()}, 1e-9);
  }

  private static ImportedInstallation withUrcaps(String urcaps) throws UnreadableFile {
    return UrInstallations.read(
        bytes(
            "<Installation><Contributions><URCaps>"
                + urcaps
                + "</URCaps></Contributions></Installation>"));
  }

  private static String externalControl(String data) {
    return "<Contributed ownerId=\"com.fzi.externalcontrol\""
        + " installationContributionTitle=\"External Control\" name=\"External Control\">"
        + data
        + "</Contributed>";
  }

  @Test
  void readsWhereExternalControlGetsItsScript() throws UnreadableFile {
    ImportedInstallation read =
        withUrcaps(
            "<Contributed name=\"Conveyor Tracking\"><data key=\"enabled\" value=\"false\"/>"
                + "</Contributed><Contributed name=\"Screwdriving\"/>"
                + externalControl(
                    "<data key=\"name\" value=\"My PC\"/><data key=\"host_ip\""
                        + " value=\"10.0.0.7\"/><data key=\"port_nr\" value=\"50012\"/>"));
    assertEquals(new ControlHost("10.0.0.7", 50012), read.installation().controlHost());
    assertEquals(List.of(), read.remarks());
    assertEquals(
        new ControlHost("10.0.0.7", 50002),
        withUrcaps(externalControl("<data key=\"host_ip\" value=\"10.0.0.7\"/>"))
            .installation()
            .controlHost());
  }

  @Test
  void tellsOfUrcapsAndHostsThatItCannotUse() throws UnreadableFile {
    ImportedInstallation read =
        withUrcaps(
            "<Contributed name=\"Gripper\"><data key=\"id\" value=\"1\"/></Contributed>"
                + externalControl("<data key=\"port_nr\" value=\"many\"/>"));
    assertEquals(ControlHost.STANDARD, read.installation().controlHost());
    assertEquals(
        List.of(
            "the URCap Gripper is not understood",
            "line 1: External Control asks 192.168.56.1:50002 instead: the port is \"many\", must"
                + " be a number"),
        read.remarks());
  }

  @Test
  void saysNothingOfWhatIsSwitchedOff() throws UnreadableFile {
    assertEquals(
        List.of("not understood, and as in a new installation: EthernetIP"),
        read("<Profinet enabled=\"false\"/><EthernetIP enabled=\"true\"/>").remarks());
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
