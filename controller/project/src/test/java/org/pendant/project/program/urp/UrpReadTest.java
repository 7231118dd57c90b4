package org.pendant.project.program.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.polyscope.xml.PackedXml;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Setting;
import org.pendant.project.program.Step;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

class UrpReadTest {
  private static final Joints JOINTS = new Joints(0.1, -1.5, -1.6, -1.4, 1.5, 0.2);

  /** As robots write a place: joints, TCP and the arm, but no pose. */
  private static final String POSITION =
      """
      <position>
        <JointAngles angles="0.1, -1.5, -1.6, -1.4, 1.5, 0.2"/>
        <TCPOffset pose="0.0, 0.0, 0.12, 0.0, 0.0, 0.0"/>
        <Kinematics status="NOT_INITIALIZED" validChecksum="false">
          <deltaTheta value="0.0, 0.0, 0.0, 0.0, 0.0, 0.0"/>
          <a value="0.0, -0.425, -0.3922, 0.0, 0.0, 0.0"/>
          <d value="0.1625, 0.0, 0.0, 0.1333, 0.0997, 0.0996"/>
          <alpha value="1.570796327, 0.0, 0.0, 1.570796327, -1.570796327, 0.0"/>
          <jointChecksum value="-1, -1, -1, -1, -1, -1"/>
        </Kinematics>
      </position>
      """;

  private static String program(String sections) {
    return "<URProgram name=\"pick\" installation=\"cell\" createdIn=\"5.24.1\">\n<children>\n"
        + sections
        + "\n</children>\n</URProgram>\n";
  }

  private static String main(String nodes) {
    return program(
        "<MainProgram runOnlyOnce=\"true\"><children>\n" + nodes + "\n</children></MainProgram>");
  }

  private static ImportedProgram read(String xml) throws UnreadableFile {
    return UrpPrograms.read("pick.urp", xml.getBytes(StandardCharsets.UTF_8));
  }

  /** The nodes of a main program. */
  private static List<ProgramNode> nodes(String xml) throws UnreadableFile {
    return read(main(xml)).tree().sections().getFirst().children();
  }

  private static Step step(String xml) throws UnreadableFile {
    return nodes(xml).getFirst().step();
  }

  private static String expression(String parts) throws UnreadableFile {
    Step step = step("<Script type=\"Line\"><expression>" + parts + "</expression></Script>");
    return ((ActionStep.ScriptLine) step).code();
  }

  private static String chars(String text) {
    StringBuilder parts = new StringBuilder();
    for (int i = 0; i < text.length(); i++) {
      String each = text.substring(i, i + 1).replace("<", "&lt;").replace("\"", "&quot;");
      parts.append("<ExpressionChar character=\"").append(each).append("\"/>");
    }
    return parts.toString();
  }

  private static String refusal(byte[] bytes) {
    return assertThrows(UnreadableFile.class, () -> UrpPrograms.read("pick.urp", bytes))
        .report("pick.urp");
  }

  private static String refusal(String xml) {
    return refusal(xml.getBytes(StandardCharsets.UTF_8));
  }

  private static void assertPose(Pose expected, Pose actual) {
    for (int i = 0; i < Pose.SIZE; i++) {
      assertEquals(expected.get(i), actual.get(i), 1e-9, () -> expected + " and " + actual);
    }
  }

  @Test
  void readsCompressedAndPlainFiles() throws UnreadableFile {
    String xml = main("<Halt/>");
    ImportedProgram plain = read(xml);
    assertEquals("pick", plain.name());
    assertEquals("cell", plain.tree().installation());
    assertEquals(plain, UrpPrograms.read("other.urp", PackedXml.packed(xml)));
  }

  @Test
  void readsMovesAndComputesThePosesOfTheirWaypoints() throws UnreadableFile {
    ImportedProgram program =
        read(
            main(
                """
                <Move motionType="MoveJ" speed="1.0" acceleration="1.4" useActiveTCP="false"
                    positionType="CartesianPose">
                  <feature class="GeomFeatureReference" referencedName="Joint_0_name"/>
                  <children>
                    <Waypoint type="Fixed" name="Above" kinematicsFlags="4">
                      <motionParameters jointSpeed="0.5" jointAcceleration="0.7"
                          cartesianSpeed="0.2" cartesianAcceleration="1.0" blendRadius="0.02"/>
                      %s
                      <BaseToFeature pose="0.0, 0.0, 0.0, 0.0, 0.0, 0.0"/>
                    </Waypoint>
                    <Waypoint type="Fixed" name="Above">
                      <motionParameters/>
                      <position reference="../../Waypoint/position"/>
                    </Waypoint>
                  </children>
                </Move>
                """
                    .formatted(POSITION)));
    ProgramNode move = program.tree().sections().getFirst().children().getFirst();
    assertEquals(
        new MotionStep.Move(MoveKind.JOINT, 1, 1.4, new ToolChoice.Flange(), "Base", false),
        move.step());
    assertEquals(
        List.of(
            new MotionStep.Waypoint(
                new WaypointTarget.Fixed("Above"),
                new Timing.Own(0.5, 0.7),
                OptionalDouble.of(0.02)),
            new MotionStep.Waypoint(
                new WaypointTarget.Fixed("Above"), new Timing.AsMove(), OptionalDouble.empty())),
        move.children().stream().map(ProgramNode::step).toList());
    WaypointPosition place = program.tree().waypoints().get("Above");
    Pose tool = new Pose(0, 0, 0.12, 0, 0, 0);
    assertEquals(JOINTS, place.jointsRad());
    assertEquals(tool, place.toolInFlange());
    assertPose(new ForwardKinematics(ArmLibrary.load("ur5e")).tcpPose(JOINTS, tool), place.tcp());
    assertEquals(List.of(), program.remarks());
  }

  @Test
  void keepsPosesInTheFeatureOfTheMove() throws UnreadableFile {
    String feature = "0.5, -0.2, 0.1, 0.0, 0.0, 1.0";
    String move =
        """
        <Move motionType="MoveL" speed="0.1" acceleration="1.0" useActiveTCP="false">
          <tcp referencedName="Grip"/>
          <feature class="GeomFeatureReference" referencedName="Table"/>
          <children><Waypoint type="Fixed" name="P">%s<BaseToFeature pose="%s"/></Waypoint></children>
        </Move>
        """
            .formatted(POSITION, feature);
    ImportedProgram program = read(main(move));
    assertEquals(
        List.of(
            new Feature(
                "Table",
                FeatureKind.POINT,
                List.of(new Pose(0.5, -0.2, 0.1, 0, 0, 1)),
                false,
                true)),
        program.features());
    ProgramTree tree = program.tree();
    MotionStep.Move step =
        (MotionStep.Move) tree.sections().getFirst().children().getFirst().step();
    assertEquals(new ToolChoice.Named("Grip"), step.tool());
    assertEquals("Table", step.feature());
    WaypointPosition place = tree.waypoints().get("P");
    assertEquals("Table", place.feature());
    Pose inBase =
        new ForwardKinematics(ArmLibrary.load("ur5e")).tcpPose(JOINTS, place.toolInFlange());
    assertPose(inBase, Poses.trans(new Pose(0.5, -0.2, 0.1, 0, 0, 1), place.tcp()));
  }

  @Test
  void readsOlderPositionsWithTheirPose() throws UnreadableFile {
    String older =
        """
        <Move motionType="MoveP" speed="0.1" acceleration="1.0" blendRadius="0.03"><children>
          <Waypoint type="Fixed" name="P">
            <position joints="0.1, -1.5, -1.6, -1.4, 1.5, 0.2" pose="0.1, 0.2, 0.3, 0, 3, 0"/>
            <poseInFeatureCoordinates pose="0.1, 0.2, 0.3, 0, 3, 0"/>
            <outputFlangePose pose="0.1, 0.2, 0.4, 0, 3, 0"/>
          </Waypoint></children></Move>
        """;
    ImportedProgram program = read(main(older));
    assertEquals(
        new WaypointPosition(new Pose(0.1, 0.2, 0.3, 0, 3, 0), "Base", JOINTS, Pose.ZERO),
        program.tree().waypoints().get("P"));
    assertEquals(
        new MotionStep.Waypoint(
            new WaypointTarget.Fixed("P"), new Timing.AsMove(), OptionalDouble.of(0.03)),
        nodes(older).getFirst().children().getFirst().step());
    assertEquals(List.of(), program.remarks());
  }

  @Test
  void joinsExpressionsToTextOfTheLanguage() throws UnreadableFile {
    assertEquals(
        "get_standard_digital_in(3) == True and n >= P_p[0]",
        expression(
            "<ExpressionIO><pin referencedName=\"digital_in[3]\"/></ExpressionIO>"
                + "<ExpressionToken token=\" \u225f \"/><ExpressionToken token=\" HI \"/>"
                + "<ExpressionToken token=\" and \"/>"
                + "<ExpressionVariable><ProgramVariable name=\"n\"/></ExpressionVariable>"
                + chars(" \u2265 ")
                + "<ExpressionWaypoint><waypoint name=\"P\"/></ExpressionWaypoint>"
                + chars("[0]")));
    assertEquals("\"\u225f < 1\"", expression(chars("\"\u225f < 1\"")));
    assertEquals(
        "get_configurable_digital_in(1) or read_input_boolean_register(70)",
        expression(
            "<ExpressionIO><pin referencedName=\"config_in[1]\"/></ExpressionIO>"
                + "<ExpressionToken token=\" or \"/>"
                + "<ExpressionIO><pin referencedName=\"GP_bool_in[70]\"/></ExpressionIO>"));
    assertEquals(
        "pose_trans(Table, Base)",
        expression(
            chars("pose_trans(")
                + "<ExpressionGeomFeature><feature"
                + " referencedName=\"Table\"/></ExpressionGeomFeature>"
                + chars(", ")
                + "<ExpressionGeomFeature><feature"
                + " referencedName=\"Joint_0_name\"/></ExpressionGeomFeature>"
                + chars(")")));
  }

  @Test
  void followsReferencesFromTheElementThatCarriesThem() throws UnreadableFile {
    String xml =
        """
        <Assignment valueSource="Expression"><variable name="a"/><expression/></Assignment>
        <Assignment valueSource="Expression"><variable name="b"/><expression/></Assignment>
        <Loop type="While"><expression>
          <ExpressionVariable>
            <ProgramVariable reference="../../../../Assignment[2]/variable"/>
          </ExpressionVariable></expression>
          <children>
            <Assignment valueSource="Expression">
              <variable reference="../../../../Assignment/variable"/>
              <expression><ExpressionVariable>
                <ProgramVariable reference="../../../../../../Loop/expression/ExpressionVariable/ProgramVariable"/>
              </ExpressionVariable></expression>
            </Assignment>
            <Timer action="Start">
              <variable reference="/URProgram/children/MainProgram/children/Assignment[2]/variable"/>
            </Timer>
          </children>
        </Loop>
        """;
    ProgramNode loop = nodes(xml).getLast();
    assertEquals(new FlowStep.Loop(new LoopRule.While("b", false)), loop.step());
    assertEquals(
        List.of(
            new ActionStep.Assignment("a", "b"),
            new ActionStep.Timer("b", ActionStep.TimerAction.START)),
        loop.children().stream().map(ProgramNode::step).toList());
  }

  @Test
  void refusesReferencesThatLeadInACircle() {
    String message =
        refusal(
            main(
                """
                <Timer action="Start"><variable reference="../../Timer[2]/variable"/></Timer>
                <Timer action="Stop"><variable reference="../../Timer/variable"/></Timer>
                """));
    assertTrue(message.startsWith("pick.urp:4:23: error: its reference "), message);
    assertTrue(message.contains("leads in a circle"), message);
  }

  @Test
  void tellsReferencesThatLeadNowhere() throws UnreadableFile {
    ImportedProgram program =
        read(main("<Timer action=\"Start\"><variable reference=\"../../Loop/variable\"/></Timer>"));
    assertEquals(
        List.of(
            "line 4, URProgram/children/MainProgram/children/Timer/variable: the reference"
                + " ../../Loop/variable of variable leads nowhere"),
        program.remarks());
  }

  @Test
  void readsSubProgramsWhereverTheyStand() throws UnreadableFile {
    ProgramTree tree =
        read(program(
                """
                <MainProgram><children>
                  <CallSubProgram><subprogram name="Pick" keepHidden="true">
                    <programFile resolves-to="file">pick.urp</programFile>
                    <children><Halt/></children></subprogram></CallSubProgram>
                  <CallSubProgram><subprogram reference="../../CallSubProgram/subprogram"/></CallSubProgram>
                  <CallSubProgram><subprogram name="Place"><children/></subprogram></CallSubProgram>
                </children></MainProgram>
                <SubProgram reference="../MainProgram/children/CallSubProgram/subprogram"/>
                """))
            .tree();
    assertEquals(
        List.of(
            new Section.MainProgram(true),
            new Section.SubProgram("Pick", "pick.urp"),
            new Section.SubProgram("Place", "")),
        tree.sections().stream().map(ProgramNode::step).toList());
    assertEquals(
        List.of(
            new ActionStep.Call("Pick"), new ActionStep.Call("Pick"), new ActionStep.Call("Place")),
        tree.sections().getFirst().children().stream().map(ProgramNode::step).toList());
    assertEquals(new ActionStep.Halt(), tree.sections().get(1).children().getFirst().step());
  }

  @Test
  void readsSectionsAndInitialValues() throws UnreadableFile {
    String sections =
        """
        <InitVariablesNode/>
        <SpecialSequence type="BeforeStart"><children><Placeholder/></children></SpecialSequence>
        <MainProgram runOnlyOnce="false" InitVariablesNode="%s"><children>
          <Assignment valueSource="Expression">
            <variable name="n" prefersPersistentValue="false"><initializeExpression>
              <ExpressionChar character="7"/></initializeExpression></variable>
            <expression><ExpressionChar character="1"/></expression>
          </Assignment></children></MainProgram>
        <Thread name="Watch"><children><Halt/></children></Thread>
        <Event><expression><ExpressionToken token=" True "/></expression></Event>
        """;
    ProgramTree tree = read(program(sections.formatted("true"))).tree();
    assertEquals(
        List.of(
            new Section.InitialValues(List.of(new Section.InitialValue("n", "7"))),
            new Section.BeforeStart(),
            new Section.MainProgram(true),
            new Section.ThreadSection("Watch", true),
            new Section.Event("True")),
        tree.sections().stream().map(ProgramNode::step).toList());
    assertEquals(List.of(), tree.sections().get(1).children());
    ProgramTree off = read(program(sections.formatted("false"))).tree();
    assertEquals(
        new Section.InitialValues(List.of(new Section.InitialValue("n", "7"))),
        off.sections().getFirst().step());
    assertTrue(off.sections().getFirst().suppressed());
  }

  @Test
  void readsWhatWaitsSetsAndTells() throws UnreadableFile {
    assertEquals(
        new ActionStep.Wait(new WaitFor.Digital("tool_in[1]", true)),
        step(
            "<Wait type=\"DigitalInput\"><pin referencedName=\"tool_in[1]\"/>"
                + "<digitalValue>1</digitalValue></Wait>"));
    assertEquals(
        new ActionStep.Wait(new WaitFor.Analog("analog_in[1]", true, 4)),
        step(
            "<Wait type=\"AnalogInput\"><pin referencedName=\"analog_in[1]\"/>"
                + "<analogComparison>1</analogComparison><analogValue>4.0</analogValue></Wait>"));
    assertEquals(
        new ActionStep.SetAction(new Setting.Digital("configurable_out[2]", false)),
        step(
            "<Set type=\"DigitalOutput\"><pin referencedName=\"config_out[2]\"/>"
                + "<digitalValue>0</digitalValue></Set>"));
    assertEquals(
        new ActionStep.SetAction(new Setting.Tcp("Grip", Pose.ZERO)),
        step("<Set type=\"NoAction\"><tcp referencedName=\"Grip\"/></Set>"));
    assertEquals(
        new ActionStep.SetAction(new Setting.NamedPayload("Box")),
        step("<SetPayload workpieceName=\"Box\"/>"));
    assertEquals(
        new ActionStep.Popup("Done & gone", false, ActionStep.PopupKind.WARNING, true),
        step("<Popup type=\"Warning\" haltProgram=\"true\" message=\"Done &amp; gone\"/>"));
    assertEquals(
        new ActionStep.ScriptFile("/programs/a.script", List.of("a()", "", "# <b>")),
        step(
            "<Script type=\"File\"><cachedContents>a()\n\n# &lt;b&gt;\n</cachedContents>"
                + "<file resolves-to=\"file\">/programs/a.script</file></Script>"));
    assertEquals(
        new FlowStep.ElseIf("a", true),
        step(
            "<If type=\"ElseIf\" checkContinuously=\"true\"><expression>%s</expression></If>"
                .formatted(chars("a"))));
    assertEquals(
        new FlowStep.Loop(new LoopRule.Times("3", "")),
        step("<Loop type=\"Counting\" count=\"3\"/>"));
    assertEquals(
        new MotionStep.Until(new UntilRule.Distance(0.1)),
        step("<Until type=\"x\"><Distance>0.1</Distance></Until>"));
    assertEquals(
        new MotionStep.Direction("Tool", 0, 0, -1, OptionalDouble.empty(), OptionalDouble.empty()),
        step(
            "<gui.program.direction.MoveDirectionNode selectedDirection=\"ZMinus\"><feature"
                + " referencedName=\"Joint_6_name\"/></gui.program.direction.MoveDirectionNode>"));
  }

  @Test
  void knowsSignalsByTheNamesOfTheInstallation() throws UnreadableFile {
    Installation none = Installation.NONE;
    Installation named =
        new Installation(
            none.robot(),
            none.calibration(),
            none.tools(),
            none.activeTool(),
            none.payloads(),
            none.activePayload(),
            none.mounting(),
            List.of(
                new SignalUse(
                    "digital_in[4]", "Part here", InputAction.DEFAULT, RunStateAction.PRESERVE)),
            none.wiring(),
            none.features(),
            none.homeRad(),
            none.variables(),
            none.startUp(),
            none.safety(),
            none.conveyors(),
            none.modbus(),
            none.ethernetIpLoss(),
            none.transitionHardness(),
            none.controlHost());
    String xml =
        main(
            "<Wait type=\"DigitalInput\"><pin referencedName=\"Part here\"/>"
                + "<digitalValue>1</digitalValue></Wait>");
    byte[] bytes = xml.getBytes(StandardCharsets.UTF_8);
    ImportedProgram program = UrpPrograms.read("pick.urp", bytes, named);
    assertEquals(
        new ActionStep.Wait(new WaitFor.Digital("digital_in[4]", true)),
        program.tree().sections().getFirst().children().getFirst().step());
    assertEquals(List.of(), program.remarks());
    assertEquals(
        List.of(
            "line 4, URProgram/children/MainProgram/children/Wait/pin: no installation says which"
                + " signal \"Part here\" is"),
        read(xml).remarks());
  }

  @Test
  void suppressesWhatIsSuppressedInEitherForm() throws UnreadableFile {
    List<ProgramNode> nodes =
        nodes(
            """
            <SuppressedNode><Folder name="a"><children><Halt/></children></Folder></SuppressedNode>
            <SuppressedNode><children><Halt/><Halt/></children></SuppressedNode>
            <Halt/>
            """);
    assertEquals(
        List.of(true, true, true, false), nodes.stream().map(ProgramNode::suppressed).toList());
    assertFalse(nodes.getFirst().children().getFirst().suppressed());
  }

  @Test
  void aNodeThatIsSwitchedOffIsWhatItsClassSays() throws UnreadableFile {
    ImportedProgram program =
        read(
            main(
                """
                <SuppressedNode><suppressedNode class="Folder" name="a"><children><Halt/></children>
                </suppressedNode></SuppressedNode>
                <SuppressedNode><suppressedNode class="Comment" comment="b" colour="c"/></SuppressedNode>
                """));
    List<ProgramNode> nodes = program.tree().sections().getFirst().children();
    assertEquals(
        List.of(new ActionStep.Folder("a"), new ActionStep.Comment("b")),
        nodes.stream().map(ProgramNode::step).toList());
    assertEquals(List.of(true, true), nodes.stream().map(ProgramNode::suppressed).toList());
    assertEquals(new ActionStep.Halt(), nodes.getFirst().children().getFirst().step());
    assertEquals(List.of(), program.remarks());
  }

  @Test
  void anUnknownNodeThatIsSwitchedOffIsKeptWithoutARemark() throws UnreadableFile {
    String weld = "<suppressedNode class=\"Weld\" speed=\"1\"/>";
    ImportedProgram program = read(main("<SuppressedNode>" + weld + "</SuppressedNode>"));
    ProgramNode node = program.tree().sections().getFirst().children().getFirst();
    assertEquals(new ForeignStep.Unknown("Weld", List.of("<Weld speed=\"1\"/>")), node.step());
    assertTrue(node.suppressed());
    assertEquals(List.of(), program.remarks());
  }

  @Test
  void wholePartsOfAProgramCanBeSwitchedOff() throws UnreadableFile {
    ImportedProgram program =
        read(
            program(
                """
                <MainProgram><children>
                <CallSubProgram><subprogram name="S"><children><Halt/></children></subprogram>
                </CallSubProgram></children></MainProgram>
                <SuppressedNode><suppressedNode class="Thread" name="T" runOnlyOnce="true">
                <children><Halt/></children></suppressedNode></SuppressedNode>
                <SuppressedNode><suppressedNode class="SubProgram"
                 reference="../../MainProgram/children/CallSubProgram/subprogram"/></SuppressedNode>
                """));
    assertEquals(
        List.of(
            "MainProgram[forever=true] false",
            "ThreadSection[name=T, forever=false] true",
            "SubProgram[name=S, file=] true"),
        program.tree().sections().stream()
            .map(each -> each.step() + " " + each.suppressed())
            .toList());
    assertEquals(List.of(), program.remarks());
  }

  @Test
  void keepsUnknownAndContributedElementsToTheLetter() throws UnreadableFile, IOException {
    String weld =
        "<Weld  speed='1'\tb=\"&#65;&lt;\" >\r\n   <!-- a < b --><x/><![CDATA[<y>]]>\n"
            + "  <children><Halt /></children>\n</Weld >";
    String grip =
        "<Contributed strategyClass=\"com.acme.Grip\" strategyProgramNodeType=\"Grip\""
            + " strategyURCapDeveloper=\"ACME\">\n <dataModel>\n  <data key=\"w\" value=\"0.1\"/>\n"
            + " </dataModel>\n</Contributed>";
    ImportedProgram program =
        read(main("<Folder name=\"f\"><children>" + weld + "\n" + grip + "</children></Folder>"));
    List<ProgramNode> kept = program.tree().sections().getFirst().children().getFirst().children();
    assertEquals(
        new ForeignStep.Unknown("Weld", List.of(weld.split("\n", -1))), kept.get(0).step());
    assertEquals(
        new ForeignStep.Contributed("ACME", "Grip", List.of(grip.split("\n", -1)), List.of()),
        kept.get(1).step());
    assertEquals(2, program.remarks().size(), () -> program.remarks().toString());
    byte[] written = UrpPrograms.write("pick", program.tree());
    try (GZIPInputStream in = new GZIPInputStream(new java.io.ByteArrayInputStream(written))) {
      String xml = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      assertTrue(xml.contains(weld), xml);
      assertTrue(xml.contains(grip), xml);
    }
    assertEquals(program.tree(), UrpPrograms.read("pick.urp", written).tree());
  }

  @Test
  void tellsOnceWhatItDoesNotUnderstand() throws UnreadableFile {
    ImportedProgram program =
        read(
            main(
                """
                <Halt how="softly"/>
                <Halt how="softly"/>
                <Comment comment="x"><picture/></Comment>
                """));
    assertEquals(
        List.of(
            "line 4, URProgram/children/MainProgram/children/Halt[1]: how=\"softly\" of Halt is"
                + " not understood (2 times)",
            "line 6, URProgram/children/MainProgram/children/Comment: <picture> of Comment is not"
                + " understood"),
        program.remarks());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          <Installation/>                       | pick.urp:1:1: error: holds a Installation, must hold a URProgram
          <URProgram/>                          | pick.urp:1:1: error: has no MainProgram
          <gui.program.ProgramRootNode/>        | pick.urp:1:1: error: holds a gui.program.ProgramRootNode: PolyScope 1.8 to 3.1 wrote this form, which cannot be read; expected a URProgram, which a newer PolyScope writes when it opens the file and saves it
          <!DOCTYPE URProgram []><URProgram/>   | pick.urp:1:1: error: has a DOCTYPE, which is not allowed here
          <?xml encoding="EBCDIC"?><URProgram/> | pick.urp: error: is written in EBCDIC, must be UTF-8
          """)
  void refusesOtherFilesWithTheirPlace(String xml, String message) {
    assertEquals(message, refusal(xml));
  }

  @Test
  void refusesWhatIsNoXml() {
    assertTrue(refusal("no xml").startsWith("pick.urp:1:1: error: is no XML: "));
    assertTrue(refusal("").contains("error: is no XML: "));
    assertTrue(refusal("<URProgram>\n  <a></b>").startsWith("pick.urp:2:"));
    assertEquals(
        "pick.urp: error: is no text in UTF-8", refusal(new byte[] {'<', (byte) 0xff, '>'}));
  }

  @Test
  void readsNothingThatTheFileOnlyPointsTo() {
    String outside =
        "<!DOCTYPE URProgram [<!ENTITY secret SYSTEM \"file:///etc/hostname\">]>"
            + "<URProgram name=\"&secret;\"/>";
    assertTrue(refusal(outside).startsWith("pick.urp:1:"), refusal(outside));
    assertTrue(
        refusal("<!-- --><!DOCTYPE a [<!ENTITY b \"c\">]><URProgram>&b;</URProgram>")
            .startsWith("pick.urp:1:"));
  }

  @Test
  void refusesEveryCut() {
    byte[] whole = PackedXml.packed(main("<Halt/>"));
    for (int length = 0; length < whole.length - 1; length++) {
      byte[] part = Arrays.copyOf(whole, length);
      assertThrows(UnreadableFile.class, () -> UrpPrograms.read("x.urp", part), "cut at " + length);
    }
  }

  @Test
  void refusesAFileThatUnpacksWithoutEnd() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream zip = new GZIPOutputStream(bytes)) {
      byte[] blanks = new byte[1 << 20];
      for (int i = 0; i < 65; i++) {
        zip.write(blanks);
      }
    }
    assertEquals(
        "pick.urp: error: has more than 67108864 bytes when unpacked",
        refusal(bytes.toByteArray()));
  }

  @Test
  void refusesElementsThatAreTooDeep() {
    String deep = "<Folder><children>".repeat(400) + "</children></Folder>".repeat(400);
    assertTrue(refusal(main(deep)).contains("nodes are more than 200 levels deep"));
    String deeper = "<a>".repeat(5000) + "</a>".repeat(5000);
    assertTrue(refusal(deeper).contains("elements stand more than 1000 deep in each other"));
  }

  @Test
  void readsTextsOfAnyLength() throws UnreadableFile {
    String code = "&lt;&amp;&#65;".repeat(100_000);
    String xml =
        "<Script type=\"File\"><cachedContents>" + code + "</cachedContents><file/></Script>";
    assertEquals(new ActionStep.ScriptFile("", List.of("<&A".repeat(100_000))), step(xml));
  }
}
