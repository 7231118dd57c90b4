package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.jog.JogDirection;
import org.pendant.controller.jog.JogFrame;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.vm.Ending;

/** The arm moves by hand while a client repeats the command, and rests otherwise. */
@Tag("slow")
final class JoggingTest {
  /** How often a screen repeats, in frames: 30 times a second. */
  private static final int REPEAT_FRAMES = 17;

  private static final long LONG = 20_000;
  private static final JogMove BASE_UP = new JogMove.TurnJoint(0, 1);

  private Controller controller = new Controller(ControllerOptions.headless());

  private static Command payload(double massKg, double x, double y, double z) {
    return new ManualCommand.DeclarePayload(massKg, new Vector3(x, y, z), Optional.empty());
  }

  private String refusal(Command command) {
    return assertInstanceOf(Reply.Refused.class, TestController.ask(controller, command))
        .refusal()
        .text();
  }

  /** Holds for a time of the robot; returns the last reply. */
  private Reply hold(JogMove move, double speedFraction, double seconds) {
    Reply reply = new Reply.Done();
    for (int i = 0; i < seconds / 0.002; i += REPEAT_FRAMES) {
      reply = TestController.ask(controller, new ManualCommand.Jog(move, speedFraction));
      frames(REPEAT_FRAMES - 1);
    }
    return reply;
  }

  private String heldUntilRefused(JogMove move) {
    for (int i = 0; i < LONG; i += REPEAT_FRAMES) {
      if (TestController.ask(controller, new ManualCommand.Jog(move, 1))
          instanceof Reply.Refused refused) {
        return refused.refusal().text();
      }
      frames(REPEAT_FRAMES - 1);
    }
    throw new AssertionError("never refused: " + move);
  }

  private void heldUntilResting(JogMove move) {
    do {
      hold(move, 1, 0.1);
    } while (arm().moving());
  }

  private void frames(int count) {
    controller.runUntil(() -> false, count);
  }

  private void rest() {
    assertTrue(controller.runUntil(() -> !arm().moving(), LONG));
  }

  private ArmState arm() {
    return controller.state().arm();
  }

  private List<String> said() {
    return controller.logSince(0).stream().map(LogEntry::text).toList();
  }

  private long jogLines() {
    return said().stream().filter(each -> each.startsWith("jogging: ")).count();
  }

  private static JogMove along(double x, double y, double z, JogFrame frame) {
    return new JogMove.MoveTool(JogDirection.along(x, y, z), frame);
  }

  @Test
  void aJointTurnsAsLongAsItIsHeldAndRestsAfterTheRelease() {
    assertEquals(new Reply.Done(), hold(BASE_UP, 1, 1));
    assertEquals(0.6, arm().targetSpeedRadPerS().get(0), 1e-9);
    TestController.done(controller, new ManualCommand.StopJog());
    rest();
    double where = arm().targetPositionRad().get(0);
    assertTrue(where > 0.4 && where < 0.55, "at " + where);
    assertEquals(
        BoxSetup.START_RAD.with(0, where), arm().targetPositionRad(), "no other joint turns");
    assertEquals(0, jogLines());
  }

  @Test
  void aHandThatIsNotHeardOfForAQuarterOfASecondHasLetGo() {
    hold(BASE_UP, 1, 1);
    frames(126 - REPEAT_FRAMES);
    assertEquals(0.6, arm().targetSpeedRadPerS().get(0), 1e-9, "still held");
    frames(100);
    assertEquals(Joints.ZERO, arm().targetSpeedRadPerS());
    assertFalse(arm().moving());
  }

  @Test
  void theSpeedIsAShareOfTheHighest() {
    hold(BASE_UP, 0.25, 1);
    assertEquals(0.15, arm().targetSpeedRadPerS().get(0), 1e-9);
  }

  @Test
  void aJointStopsBeforeTheEndOfItsRangeAndTheLogTellsOnce() {
    String reason = heldUntilRefused(new JogMove.TurnJoint(2, -1));
    assertEquals("joint 2 is at the end of its range", reason);
    hold(new JogMove.TurnJoint(2, -1), 1, 1);
    rest();
    double smallest = ArmLibrary.load("ur5e").joints().get(2).lowestRad();
    double where = arm().targetPositionRad().get(2);
    assertTrue(where > smallest && where < smallest + 0.02, where + " of " + smallest);
    assertEquals(1, jogLines());
    assertEquals(SafetyMode.NORMAL, controller.state().safety().safetyMode());
    TestController.done(controller, new ManualCommand.StopJog());
    assertEquals(new Reply.Done(), hold(new JogMove.TurnJoint(2, 1), 1, 0.5));
  }

  @Test
  void theTcpKeepsToALineAlongAnAxisOfTheBase() {
    Pose start = arm().targetTcpInBase();
    double speed = 0;
    Pose before = start;
    for (int i = 0; i < 600; i++) {
      if (i % REPEAT_FRAMES == 0) {
        TestController.done(controller, new ManualCommand.Jog(along(0, 0, 1, JogFrame.BASE), 1));
      } else {
        controller.advance();
      }
      Pose now = arm().targetTcpInBase();
      speed = Math.max(speed, Poses.pointDistance(before, now) / 0.002);
      assertEquals(start.x(), now.x(), 1e-9);
      assertEquals(start.y(), now.y(), 1e-9);
      assertEquals(0, Poses.rotationAngle(start, now), 1e-9);
      before = now;
    }
    assertEquals(0.25, speed, 1e-6);
    assertTrue(before.z() > start.z() + 0.15, "rose to " + before.z());
  }

  @Test
  void theTcpMovesAlongAnAxisOfTheToolOrOfAnyFrame() {
    Pose start = arm().targetTcpInBase();
    hold(along(0, 0, 1, JogFrame.TOOL), 1, 0.5);
    Pose moved = Poses.trans(Poses.inverse(start), arm().targetTcpInBase());
    assertEquals(0, moved.x(), 1e-9);
    assertEquals(0, moved.y(), 1e-9);
    assertTrue(moved.z() > 0.02, "by " + moved.z());
    TestController.done(controller, new ManualCommand.StopJog());
    rest();
    Pose frame = new Pose(5, 5, 5, 0, 0, Math.PI / 2);
    Pose there = arm().targetTcpInBase();
    hold(along(1, 0, 0, new JogFrame.Given(frame)), 1, 0.5);
    assertEquals(there.x(), arm().targetTcpInBase().x(), 1e-9);
    assertTrue(arm().targetTcpInBase().y() > there.y() + 0.02);
  }

  @Test
  void theToolTurnsAboutAnAxisThroughTheTcpAtAtMostOneRadianASecond() {
    TestController.done(
        controller,
        new ManualCommand.SetTool(new ToolCentre(new Pose(0, 0, 0.1, 0, 0, 0), "gripper")));
    Pose start = arm().targetTcpInBase();
    JogMove turn = new JogMove.MoveTool(JogDirection.around(0, 0, 1), JogFrame.BASE);
    hold(turn, 1, 1);
    Pose before = arm().targetTcpInBase();
    TestController.done(controller, new ManualCommand.Jog(turn, 1));
    Pose now = arm().targetTcpInBase();
    assertEquals(1, Poses.rotationAngle(before, now) / 0.002, 1e-6);
    assertEquals(0, Poses.pointDistance(start, now), 1e-9);
    assertTrue(Poses.sub(now, start).rz() > 0.5, "right-handed");
  }

  @Test
  void aToolThatLeavesTheReachComesToRestAndTheReplyTellsWhy() {
    String reason = heldUntilRefused(along(1, 0, 0, JogFrame.BASE));
    assertTrue(reason.contains("singularity") || reason.contains("reach"), reason);
    hold(along(1, 0, 0, JogFrame.BASE), 1, 1);
    rest();
    assertEquals(1, jogLines());
    assertTrue(said().stream().noneMatch(each -> each.contains("protective")), said().toString());
    assertEquals(SafetyMode.NORMAL, controller.state().safety().safetyMode());
    assertEquals(Optional.empty(), arm().fault());
    TestController.done(controller, new ManualCommand.StopJog());
    assertEquals(new Reply.Done(), hold(new JogMove.ToJoints(BoxSetup.START_RAD), 1, 0.5));
  }

  @Test
  void whereverTheToolIsHeldToGoItComesToRestWithoutASafetyStop() {
    SplittableRandom random = new SplittableRandom(11);
    for (int i = 0; i < 60; i++) {
      Joints start =
          new Joints(
              random.nextDouble(-1, 1),
              random.nextDouble(-2.2, -0.8),
              random.nextDouble(-2.2, -0.4),
              random.nextDouble(-2, 0),
              random.nextDouble(0.4, 2.5),
              0);
      controller = new Controller(ControllerOptions.headless().withStart(start));
      double[] axis = random.doubles(3, -1, 1).toArray();
      JogDirection direction =
          i % 2 == 0
              ? JogDirection.along(axis[0], axis[1], axis[2])
              : JogDirection.around(axis[0], axis[1], axis[2]);
      JogMove move = new JogMove.MoveTool(direction, JogFrame.BASE);
      String reason = heldUntilRefused(move);
      frames(500);
      String where = move + " from " + start + ": " + reason;
      assertEquals(Joints.ZERO, arm().targetSpeedRadPerS(), where);
      assertEquals(
          SafetyMode.NORMAL, controller.state().safety().safetyMode(), () -> where + said());
      assertEquals(1, jogLines(), where);
    }
  }

  @Test
  void anArmThatIsLetGoCloseToALimitRestsBeforeItToo() {
    for (int held = 400; held < 1500; held += 50) {
      controller = new Controller(ControllerOptions.headless());
      hold(along(1, 0.2, 0.1, JogFrame.BASE), 1, held * 0.002);
      TestController.done(controller, new ManualCommand.StopJog());
      rest();
      frames(200);
      assertEquals(SafetyMode.NORMAL, controller.state().safety().safetyMode());
      assertTrue(said().stream().noneMatch(each -> each.contains("protective")));
      assertTrue(arm().targetPositionRad().get(2) < 0, "the elbow has not passed its singularity");
    }
  }

  @Test
  void theToolStopsBeforeASafetyPlane() {
    SafetyPlane floor = new SafetyPlane("floor", 0, 0, 0.3, new Axis(0, 0, 1), Applies.BOTH, false);
    controller =
        new Controller(
            ControllerOptions.headless()
                .withSafety(
                    SafetyConfiguration.standard(ArmLibrary.load("ur5e")).withPlanes(floor)));
    String reason = heldUntilRefused(along(0, 0, -1, JogFrame.BASE));
    assertTrue(reason.contains("safety plane"), reason);
    rest();
    frames(100);
    double height = arm().actualTcpInBase().z();
    assertTrue(height > 0.3 && height < 0.33, "at " + height);
    assertEquals(SafetyMode.NORMAL, controller.state().safety().safetyMode());
    TestController.done(controller, new ManualCommand.StopJog());
    assertEquals(new Reply.Done(), hold(along(0, 0, 1, JogFrame.BASE), 1, 0.5), "back up");
  }

  @Test
  void aGoalIsReachedWhileHeldAndStaysReached() {
    Joints goal = new Joints(0.3, -1.4, -1.6, -1.5, 1.5, 0.2);
    heldUntilResting(new JogMove.ToJoints(goal));
    assertEquals(goal, arm().targetPositionRad());
    assertEquals(new Reply.Done(), hold(new JogMove.ToJoints(goal), 1, 0.5));
    assertEquals(0, jogLines());
  }

  @Test
  void aPoseIsReachedByAllJointsOrInAStraightLine() {
    Pose goal = Poses.add(arm().targetTcpInBase(), new Pose(0.05, 0.1, -0.1, 0, 0, 0));
    heldUntilResting(new JogMove.ToPose(goal));
    assertEquals(0, Poses.distance(goal, arm().targetTcpInBase()), 1e-9);
    Pose second = Poses.add(goal, new Pose(0, -0.1, 0, 0, 0, 0));
    heldUntilResting(new JogMove.StraightTo(second));
    assertEquals(0, Poses.distance(second, arm().targetTcpInBase()), 1e-9);
  }

  @Test
  void goalsThatCannotBeReachedAreRefusedWithTheCause() {
    assertEquals(
        "the goal is out of reach: farther than the stretched arm reaches",
        refusal(new ManualCommand.Jog(new JogMove.ToPose(new Pose(2, 0, 0, 0, 0, 0)), 1)));
    String joint = refusal(new ManualCommand.Jog(new JogMove.ToJoints(Joints.ZERO.with(2, 9)), 1));
    assertTrue(joint.startsWith("joint 2 would be at 9.0 rad, must be -"), joint);
    assertEquals(
        "speed is 1.5, must be above 0 and at most 1",
        refusal(new ManualCommand.Jog(BASE_UP, 1.5)));
  }

  @Test
  void whileAProgramHasTheArmHandsAreOff() {
    TestController.done(
        controller,
        new ProgramCommand.StartProgram(
            TestController.program(controller, "def p():\n sleep(1)\nend\n")));
    assertEquals(
        "program p runs, stop it before the arm is moved by hand",
        refusal(new ManualCommand.Jog(BASE_UP, 1)));
    assertEquals(
        "program p runs, stop it before the TCP is changed",
        refusal(new ManualCommand.SetTool(ToolCentre.FLANGE)));
    TestController.done(controller, new ProgramCommand.PauseProgram());
    assertEquals(
        "program p is paused, stop it before the arm is moved by hand",
        refusal(new ManualCommand.Jog(BASE_UP, 1)));
    TestController.done(controller, new ProgramCommand.StopProgram());
    TestController.done(controller, new ManualCommand.Jog(BASE_UP, 1));
  }

  @Test
  void aProgramThatStartsTakesTheArmOver() {
    hold(BASE_UP, 1, 1);
    TestController.done(
        controller,
        new ProgramCommand.StartProgram(
            TestController.program(
                controller, "def p():\n movej([0, -1.57, -1.57, -1.57, 1.57, 0])\nend\n")));
    assertTrue(controller.runUntil(() -> controller.state().program().ending().isPresent(), LONG));
    assertInstanceOf(Ending.Finished.class, controller.state().program().ending().orElseThrow());
    assertEquals(0, arm().targetPositionRad().get(0));
  }

  @Test
  void whatHoldsForHandsDoesNotHoldForTheProgramThatFollows() {
    hold(along(0, 0, 1, JogFrame.BASE), 1, 0.5);
    TestController.done(
        controller,
        new ProgramCommand.StartProgram(
            TestController.program(
                controller, "def p():\n movej([0, -1.57, 0.5, -1.57, 1.57, 0], a=3, v=2)\nend\n")));
    assertTrue(controller.runUntil(() -> controller.state().program().ending().isPresent(), LONG));
    assertEquals(0.5, arm().targetPositionRad().get(2), "beyond the elbow singularity");
    assertEquals(0, jogLines());
  }

  @Test
  void anEmergencyStopIsNotSoftenedByALimitAhead() {
    hold(along(1, 0, 0, JogFrame.BASE), 1, 1);
    TestController.done(
        controller, new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true));
    assertTrue(
        controller.runUntil(() -> arm().targetSpeedRadPerS().equals(Joints.ZERO), 250),
        "rests within 0.5 s");
    assertEquals(SafetyMode.ROBOT_EMERGENCY_STOP, controller.state().safety().safetyMode());
    assertEquals(0, jogLines());
  }

  @Test
  void anArmThatIsOffOrStoppedStaysWhereItIs() {
    controller = new Controller(ControllerOptions.headless().withPower(false));
    controller.advance();
    String off = refusal(new ManualCommand.Jog(BASE_UP, 1));
    assertTrue(off.contains("power it on"), off);
    controller = new Controller(ControllerOptions.headless());
    hold(BASE_UP, 1, 1);
    TestController.done(
        controller, new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    assertInstanceOf(Reply.Refused.class, hold(BASE_UP, 1, 0.5));
    assertEquals(Joints.ZERO, arm().targetSpeedRadPerS());
    TestController.done(
        controller, new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, false));
    frames(10);
    TestController.done(controller, new ManualCommand.StopJog());
    double before = arm().targetPositionRad().get(0);
    assertEquals(new Reply.Done(), hold(BASE_UP, 1, 0.5));
    assertTrue(arm().targetPositionRad().get(0) > before + 0.05, "moves again after the stop");
  }

  @Test
  void anotherMoveBeginsWhenTheArmRestsFromTheFirst() {
    hold(BASE_UP, 1, 1);
    assertEquals(new Reply.Done(), hold(new JogMove.TurnJoint(1, 1), 1, 1));
    assertEquals(0, arm().targetSpeedRadPerS().get(0));
    assertTrue(arm().targetPositionRad().get(1) > BoxSetup.START_RAD.get(1) + 0.2);
  }

  @Test
  void theToolCentreAndThePayloadAreSetByHand() {
    ToolCentre tool = new ToolCentre(new Pose(0, 0, 0.12, 0, 0, 0), "gripper");
    TestController.done(controller, new ManualCommand.SetTool(tool));
    assertEquals(tool, arm().tool());
    TestController.done(controller, payload(1.5, 0, 0, 0.05));
    assertEquals(1.5, controller.state().readings().payload().massKg());
    assertEquals(0.05, controller.state().readings().payload().cogZM());
    assertEquals("the mass is 50 kg, must be 0 to 20 kg on UR5e", refusal(payload(50, 0, 0, 0)));
    assertEquals(
        "the centre of gravity is at [0, 0, 50] m, each must be -4 to 4 m",
        refusal(payload(1, 0, 0, 50)));
    Vector3 middle = new Vector3(0, 0, 0);
    Inertia plate = new Inertia(0.01, 0.01, 0.02, 0, 0, 0);
    TestController.done(
        controller, new ManualCommand.DeclarePayload(2, middle, Optional.of(plate)));
    assertEquals(0.02, controller.state().readings().payload().izz());
    assertEquals(
        "the inertia is refused: the first three must not be negative",
        refusal(
            new ManualCommand.DeclarePayload(
                2, middle, Optional.of(new Inertia(-1, 1, 1, 0, 0, 0)))));
    assertEquals(
        "the TCP is at [0, 9, 0] m, each must be -4 to 4 m",
        refusal(new ManualCommand.SetTool(new ToolCentre(new Pose(0, 9, 0, 0, 0, 0), ""))));
    hold(BASE_UP, 1, 0.3);
    assertEquals(
        "the arm is moving, must be at rest when the TCP is changed",
        refusal(new ManualCommand.SetTool(ToolCentre.FLANGE)));
  }
}
