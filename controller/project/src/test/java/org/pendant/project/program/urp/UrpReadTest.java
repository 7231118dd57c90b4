package org.pendant.project.program.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.urp.UrpFixture.JOINTS;
import static org.pendant.project.program.urp.UrpFixture.POSITION;
import static org.pendant.project.program.urp.UrpFixture.assertPose;
import static org.pendant.project.program.urp.UrpFixture.chars;
import static org.pendant.project.program.urp.UrpFixture.expression;
import static org.pendant.project.program.urp.UrpFixture.main;
import static org.pendant.project.program.urp.UrpFixture.nodes;
import static org.pendant.project.program.urp.UrpFixture.program;
import static org.pendant.project.program.urp.UrpFixture.read;
import static org.pendant.project.program.urp.UrpFixture.refusal;
import static org.pendant.project.program.urp.UrpFixture.step;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.OptionalDouble;
import java.util.zip.GZIPInputStream;
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
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

/** What is read from PolyScope's programs. */
class UrpReadTest {
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
}
