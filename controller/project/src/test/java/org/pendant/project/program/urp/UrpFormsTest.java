package org.pendant.project.program.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.installation.Installation;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Section;
import org.pendant.project.program.Section.InitialValue;
import org.pendant.project.program.Step;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.Timing;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointTarget;

/** Nodes in the forms that robots have saved. */
class UrpFormsTest {
  private static final OptionalDouble NONE = OptionalDouble.empty();

  private static ImportedProgram read(String sections) throws UnreadableFile {
    String xml = "<URProgram name=\"p\"><children>" + sections + "</children></URProgram>";
    ImportedProgram program = UrpPrograms.read("p.urp", xml.getBytes(StandardCharsets.UTF_8));
    assertEquals(
        program.tree(),
        UrpPrograms.read("p.urp", UrpPrograms.write("p", program.tree())).tree(),
        "what is written is read again");
    assertEquals(List.of(), UrpPrograms.ownForms("p", program.tree(), Installation.NONE));
    return program;
  }

  private static ImportedProgram main(String nodes) throws UnreadableFile {
    return read("<MainProgram><children>" + nodes + "</children></MainProgram>");
  }

  private static ProgramNode node(String xml) throws UnreadableFile {
    ImportedProgram program = main(xml);
    assertEquals(List.of(), program.remarks());
    return program.tree().sections().getFirst().children().getFirst();
  }

  private static Step step(String xml) throws UnreadableFile {
    return node(xml).step();
  }

  private static String chars(String text) {
    StringBuilder parts = new StringBuilder();
    text.chars()
        .forEach(
            each ->
                parts.append("<ExpressionChar character=\"").appendCodePoint(each).append("\"/>"));
    return parts.toString();
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void readsTheListOfInitialValuesAndWhetherItIsSwitchedOn(boolean on) throws UnreadableFile {
    ImportedProgram program =
        read(
            """
            <InitVariablesNode><variables>
              <variable name="v1"><expression><ExpressionToken token=" False "/></expression></variable>
              <variable name="n"><expression><ExpressionChar character="0"/></expression></variable>
            </variables></InitVariablesNode>
            <MainProgram runOnlyOnce="true" InitVariablesNode="%s"/>
            """
                .formatted(on));
    ProgramNode initial = program.tree().sections().getFirst();
    assertEquals(
        new Section.InitialValues(
            List.of(new InitialValue("v1", "False"), new InitialValue("n", "0"))),
        initial.step());
    assertEquals(!on, initial.suppressed());
    assertEquals(List.of(), program.remarks());
  }

  @Test
  void saysNothingOfInitialValuesThatAreSwitchedOffAndEmpty() throws UnreadableFile {
    ImportedProgram program =
        read("<InitVariablesNode/><MainProgram InitVariablesNode=\"false\"/>");
    assertEquals(
        List.of(new Section.MainProgram(true)),
        program.tree().sections().stream().map(ProgramNode::step).toList());
    assertEquals(List.of(), program.remarks());
  }

  @Test
  void readsHowLongTheWayToAWaypointTakes() throws UnreadableFile {
    assertEquals(
        new MotionStep.Waypoint(new WaypointTarget.Variable("spot"), new Timing.Duration(2), NONE),
        node("""
        <Move motionType="MoveJ"><children><Waypoint type="Variable">
          <motionParameters nextMotionTime="2.0"/><variable name="spot"/>
        </Waypoint></children></Move>
        """)
            .children()
            .getFirst()
            .step());
    assertEquals(
        new MotionStep.Home(1, 1.4, OptionalDouble.of(3)),
        step(
            "<SafeHome positionOptionType=\"TIME\" speed=\"1.0\" acceleration=\"1.4\""
                + " nextMotionTime=\"3.0\"/>"));
    assertEquals(
        new MotionStep.Home(1, 1.4, NONE),
        step(
            "<SafeHome positionOptionType=\"SPEED_AND_ACCELERATION\" speed=\"1.0\""
                + " acceleration=\"1.4\" nextMotionTime=\"3.0\"/>"));
  }

  @Test
  void tellsATimeThatAProcessMoveCannotKeep() throws UnreadableFile {
    assertEquals(
        List.of(
            "line 1, URProgram/children/MainProgram/children/Move/children/Waypoint/"
                + "motionParameters: nextMotionTime=\"2.0\" of motionParameters is not understood"),
        main("<Move motionType=\"MoveP\"><children><Waypoint type=\"Variable\">"
                + "<motionParameters nextMotionTime=\"2.0\"/><variable name=\"spot\"/>"
                + "</Waypoint></children></Move>")
            .remarks());
  }

  @Test
  void readsWaypointsAtFeatures() throws UnreadableFile {
    assertEquals(
        new WaypointTarget.Variable("Point_1"),
        ((MotionStep.Waypoint)
                node("""
                <Move motionType="MoveJ"><children><Waypoint type="Variable" name="W">
                  <variable featureName="Point_1"/>
                </Waypoint></children></Move>
                """)
                    .children()
                    .getFirst()
                    .step())
            .target());
  }

  @Test
  void readsRelativeWaypoints() throws UnreadableFile {
    String joints = "<JointAngles angles=\"0, -1.5, -1.5, -1.5, 1.5, %s\"/>";
    ImportedProgram program =
        main(
            """
            <Move motionType="MoveL"><children>
              <Waypoint type="Relative" name="R" kinematicsFlags="4"><motionParameters/>
                <relativeFromPosition pose="0, 0, 0.1, 0, 0, 0">%s</relativeFromPosition>
                <position pose="0, 0, 0.2, 0, 0, 0">%s</position>
              </Waypoint></children></Move>
            """
                .formatted(joints.formatted("0"), joints.formatted("1")));
    assertEquals(0.1, program.tree().waypoints().get("R_from").tcp().z());
    assertEquals(0.2, program.tree().waypoints().get("R_to").tcp().z());
  }

  @Test
  void readsDirectionsAlongAnAxisWithTheirOwnSpeed() throws UnreadableFile {
    assertEquals(
        new MotionStep.Direction("Tool", 0, 0, -1, OptionalDouble.of(0.01), OptionalDouble.of(0.6)),
        step(
            """
            <gui.program.direction.MoveDirectionNode selectedDirection="ZMinus" toolParams="0.01, 0.6">
              <feature class="GeomFeatureReference" referencedName="Joint_6_name"/>
            </gui.program.direction.MoveDirectionNode>
            """));
    assertEquals(
        new MotionStep.Direction("Base", 1, 0, 0, NONE, NONE),
        step("<gui.program.direction.MoveDirectionNode selectedDirection=\"XPlus\"/>"));
  }

  @Test
  void readsDirectionsThatAnExpressionSays() throws UnreadableFile {
    String element =
        "<gui.program.direction.MoveDirectionNode><expression class=\"ExpressionBranch\">%s"
            + "</expression></gui.program.direction.MoveDirectionNode>";
    assertEquals(
        new MotionStep.Direction("Base", 1, 0, -0.5, NONE, NONE),
        step(element.formatted(chars("[1.0,0.0,-0.5]"))));
    assertEquals(
        new MotionStep.Direction("Base", 0, 0, 0, "way[i]", NONE, NONE),
        step(element.formatted(chars("way[i]"))));
  }

  @Test
  void readsWhatEndsAWay() throws UnreadableFile {
    ProgramNode way =
        node(
            """
            <gui.program.direction.MoveDirectionNode selectedDirection="XPlus"><children>
              <Until type="DISTANCE" allowActions="false" deceleration="3.0" distanceNodeType="STOP">
                <Distance>0.02</Distance><motionParameters blendRadius="0.0"/></Until>
              <Until type="TOOL_CONTACT_DETECTION" allowActions="true" retraction="0.002"
                  decelerationAcceleration="2.0" decelerationAngularAcceleration="34.9">
                <children><Wait type="NoWait"/></children></Until>
            </children></gui.program.direction.MoveDirectionNode>
            """);
    assertEquals(
        List.of(
            new MotionStep.Until(new UntilRule.Distance(0.02)),
            new MotionStep.Until(new UntilRule.Contact(0.002, 2))),
        way.children().stream().map(ProgramNode::step).toList());
    assertEquals(
        new ActionStep.Wait(new WaitFor.Nothing()),
        way.children().getLast().children().getFirst().step());
  }

  @Test
  void aDistanceMayEndWithABlend() throws UnreadableFile {
    ImportedProgram read =
        main(
            "<Until type=\"DISTANCE\" distanceNodeType=\"BLEND\"><Distance>0.1</Distance>"
                + "<motionParameters blendRadius=\"0.05\"/></Until>");
    assertEquals(List.of(), read.remarks());
    assertEquals(
        new MotionStep.Until(new UntilRule.Distance(0.1, OptionalDouble.of(0.05))),
        read.tree().sections().getFirst().children().getFirst().step());
  }

  /** The blend of each waypoint and circle of the first move. */
  private static List<OptionalDouble> blends(String after) throws UnreadableFile {
    ImportedProgram program =
        main(
            """
            <Move motionType="MoveP" blendRadius="0.025"><children>
              <Waypoint type="Variable"><variable name="a"/></Waypoint>
              <CircleMove OrientationMode="FIXED"><children>
                <Waypoint type="Variable"><variable name="b"/></Waypoint>
                <Waypoint type="Variable"><variable name="c"/></Waypoint>
              </children></CircleMove>
              <Waypoint type="Variable"><variable name="d"/></Waypoint>
            </children></Move>
            """
                + after);
    return program.tree().sections().getFirst().children().getFirst().children().stream()
        .map(
            each ->
                each.step() instanceof MotionStep.CircleMove circle
                    ? circle.blendRadiusM()
                    : ((MotionStep.Waypoint) each.step()).blendRadiusM())
        .toList();
  }

  private static String move(String type, String child) {
    return "<Move motionType=\"" + type + "\"><children>" + child + "</children></Move>";
  }

  @Test
  void sharesTheBlendOfAProcessMoveUntilAnotherMoveFollows() throws UnreadableFile {
    OptionalDouble shared = OptionalDouble.of(0.025);
    String waypoint = "<Waypoint type=\"Variable\"><variable name=\"e\"/></Waypoint>";
    List<OptionalDouble> all = List.of(shared, shared, shared);
    assertEquals(all, blends(""));
    assertEquals(all, blends("<Halt/>" + move("MoveL", waypoint)));
    assertEquals(all, blends(move("MoveP", waypoint)));
    assertEquals(
        all,
        blends(
            move(
                "MoveL",
                "<gui.program.direction.MoveDirectionNode selectedDirection=\"XPlus\"/>")));
    assertEquals(List.of(shared, shared, NONE), blends(move("MoveL", waypoint)));
    assertEquals(List.of(shared, shared, NONE), blends(move("MoveJ", waypoint)));
    // what does not move, or is switched off, may stand before the waypoint
    assertEquals(
        List.of(shared, shared, NONE),
        blends(
            move(
                "MoveJ",
                "<Halt/><SuppressedNode><suppressedNode class=\"Waypoint\" type=\"Fixed\""
                    + " name=\"off\"/></SuppressedNode>"
                    + waypoint)));
  }

  @Test
  void theLargestNumberIsTheCaseThatRunsWhenNoOtherDoes() throws UnreadableFile {
    assertEquals(new FlowStep.Case("7"), step("<Case caseValue=\"7\"/>"));
    assertEquals(new FlowStep.DefaultCase(), step("<Case caseValue=\"2147483647\"/>"));
  }

  @Test
  void namesInOtherLettersHaveInExpressionsTheNameThatTheyHaveInScripts() throws UnreadableFile {
    assertEquals(
        new ActionStep.Assignment("u24490_1", "u24490_1+u1050_p"),
        step(
            """
            <Assignment valueSource="Expression"><variable name="\u5faa_1"/><expression>
              <ExpressionVariable><variable name="\u5faa_1"/></ExpressionVariable>
              <ExpressionChar character="+"/>
              <ExpressionWaypoint><waypoint name="\u041a"/></ExpressionWaypoint>
            </expression></Assignment>
            """));
  }

  @ParameterizedTest
  @ValueSource(strings = {"Simple", "Frame", "Point", "Motion"})
  void readsForceNodesWithWhatIsBelowThem(String type) throws UnreadableFile {
    ProgramNode force =
        node(
            """
            <Force type="%s">
              <feature referencedName="Joint_6_name"/>
              <selection value="0, 0, 1, 0, 0, 1"/>
              <wrench value="0.0, 0.0, 10.0, 0.0, 0.0, 0.5"/>
              <limitsForce value="0.15, 0.15, 0.2, 1.0, 1.0, 1.1"/>
              <limitsMotion value="0.1, 0.11, 0.12, 0.3, 0.31, 0.32"/>
              <children><Wait type="NoWait"/></children>
            </Force>
            """
                .formatted(type));
    assertEquals(
        new TemplateStep.Force(
            TemplateStep.ForceKind.valueOf(type.toUpperCase(Locale.ROOT)),
            "Tool",
            List.of(false, false, true, false, false, true),
            List.of(0.0, 0.0, 10.0, 0.0, 0.0, 0.5),
            List.of(0.1, 0.11, 0.2, 0.3, 0.31, 1.1)),
        force.step());
    assertEquals(1, force.children().size());
  }

  private static ImportedProgram madeOn(String theta, String a, String d) throws UnreadableFile {
    String xml =
        """
        <URProgram name="p">
          <kinematics status="LINEARIZED" validChecksum="true">
            <deltaTheta value="%s"/><a value="%s"/><d value="%s"/>
            <alpha value="1.570796327, 0.0, 0.0, 1.570796327, -1.570796327, 0.0"/>
          </kinematics>
          <children><MainProgram/></children></URProgram>
        """
            .formatted(theta, a, d);
    return UrpPrograms.read("p.urp", xml.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void knowsTheArmThatAProgramWasMadeOn() throws UnreadableFile {
    String none = "0.0, 0.0, 0.0, 0.0, 0.0, 0.0";
    ImportedProgram usual =
        madeOn(
            none,
            "0.0, -0.425, -0.3922, 0.0, 0.0, 0.0",
            "0.1625, 0.0, 0.0, 0.1333, 0.0997, 0.0996");
    assertEquals(Optional.of("ur5e"), usual.robot());
    assertEquals(List.of(), usual.remarks());
    ImportedProgram calibrated =
        madeOn(
            "0.001, -0.0005, 0.0004, 0.0, 0.0, 0.0",
            "0.0001, -0.6128, -0.5715, 0.0, 0.0, 0.0",
            "0.1806, 120.0, -120.0, 0.1743, 0.1198, 0.1165");
    assertEquals(Optional.of("ur10e"), calibrated.robot());
    assertEquals(List.of("line 1, URProgram: it was made on a ur10e"), calibrated.remarks());
    ImportedProgram other =
        madeOn(none, "0.0, -0.5, -0.5, 0.0, 0.0, 0.0", "0.2, 0.0, 0.0, 0.1, 0.1, 0.1");
    assertEquals(Optional.empty(), other.robot());
    assertEquals(
        List.of("line 1, URProgram: the arm that it was made on is none of those that are known"),
        other.remarks());
  }

  @Test
  void passesOverTheSpeedsOfAnOptimalMoveThatIsSwitchedOff() throws UnreadableFile {
    String move =
        "<Move motionType=\"MoveJ\" optimoveEnabled=\"%s\" optiMoveSpeed=\"0.3\""
            + " optiMoveAcceleration=\"0.09\"/>";
    assertEquals(List.of(), main(move.formatted("false")).remarks());
    assertEquals(
        List.of(
            "line 1, URProgram/children/MainProgram/children/Move: an OptiMove is made as an"
                + " ordinary move of its speed"),
        main(move.formatted("true")).remarks());
  }
}
