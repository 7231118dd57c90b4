package org.pendant.desktop.move;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.InstallationCommand;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.Pace;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.jog.JogDirection;
import org.pendant.controller.jog.JogFrame;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.debug.Debugger;

/** What the screen that moves the arm tells and does. */
final class MovePresenterTest extends MoveFixture {
  @Test
  void unitsThatAreChosenElsewhereAreThoseOfThisScreen() {
    PoseForm inches =
        new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.ROLL_PITCH_YAW);
    FormMemory.write(settings, inches);
    refresh(1);
    assertEquals(inches, presenter.form());
    assertEquals(DisplayUnit.INCH, presenter.goals().pose().unit(0));
  }

  @Test
  void aHeldJointTurnsUntilItIsLetGo() {
    refresh(1);
    presenter.jog().turn(0, 1);
    refresh(60);
    assertTrue(position().get(0) > 0.2, "at " + position().get(0));
    presenter.jog().release();
    refresh(20);
    Joints rest = position();
    refresh(20);
    assertEquals(rest, position());
  }

  @Test
  void aScreenThatIsNoLongerRefreshedMovesNothing() {
    refresh(1);
    presenter.jog().turn(0, 1);
    refresh(20);
    controller.runUntil(() -> false, 300);
    assertEquals(Joints.ZERO, controller.state().arm().targetSpeedRadPerS());
  }

  @Test
  void theToolMovesAlongTheChosenAxesAtTheChosenSpeed() {
    refresh(1);
    presenter.jog().setAxes(JogAxes.TOOL);
    presenter.jog().setSpeedFraction(0.2);
    JogDirection up = JogDirection.along(0, 0, 1);
    presenter.jog().move(up);
    assertEquals(
        new ManualCommand.Jog(new JogMove.MoveTool(up, JogFrame.TOOL), 0.2), sent.getLast());
  }

  @Test
  void anArmThatIsOffIsOfferedToBeSwitchedOn() {
    controller = new Controller(ControllerOptions.headless().withPower(false));
    refresh(1);
    assertFalse(presenter.movable());
    assertEquals("Power off: the arm cannot be moved.", obstacle());
    presenter.jog().turn(0, 1);
    assertEquals(List.of(), sent);
    assertEquals("Switch on", presenter.obstacle().orElseThrow().remedy());
    presenter.removeObstacle();
    refresh(200);
    assertTrue(presenter.movable(), obstacle());
  }

  @Test
  void aRunningProgramIsOfferedToBeStopped() {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                TestController.program(controller, "def p():\n sleep(9)\nend\n")));
    refresh(1);
    assertEquals("Program p is running. Stop it to move the arm by hand.", obstacle());
    presenter.removeObstacle();
    refresh(1);
    assertEquals("", obstacle());
  }

  @Test
  void aProgramThatADebuggerHoldsIsPaused() {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                TestController.program(controller, "def p():\n sleep(9)\nend\n")));
    refresh(1);
    var _ = controller.submit(new DebugCommand.Debug(Debugger::pause));
    refresh(1);
    assertEquals("Program p is paused. Stop it to move the arm by hand.", obstacle());
  }

  @Test
  void aStopThatComesWhileAButtonIsHeldLetsItGo() {
    refresh(1);
    presenter.jog().turn(0, 1);
    refresh(20);
    var _ = controller.submit(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    refresh(2);
    assertEquals(new ManualCommand.StopJog(), sent.getLast());
    assertTrue(obstacle().startsWith("Safeguard stop."), obstacle());
  }

  @Test
  void timeMustGoByAtAPaceThatHandsCanFollow() {
    refresh(1);
    presenter.take(controller.state(), new Pace.Paused());
    assertEquals("Robot time is paused. Continue it to move the arm by hand.", obstacle());
    presenter.take(controller.state(), new Pace.Times(5));
    assertTrue(obstacle().contains("at most 4 times"), obstacle());
    presenter.take(controller.state(), new Pace.Times(4));
    assertEquals("", obstacle());
  }

  @Test
  void aSliderAtZeroIsTold() {
    var _ = controller.submit(new BoxCommand.SetSpeedFraction(0));
    refresh(1);
    assertEquals("The speed slider is at 0 %, so the arm stands still. Move it up.", obstacle());
  }

  @Test
  void typedJointsAreGoneToAndShownAsAGhost() {
    refresh(1);
    presenter.goals().joints().type(0, "20");
    refresh(1);
    assertEquals(Math.toRadians(20), ghosts.getLast().orElseThrow().get(0), 1e-12);
    presenter.holdJointGoal();
    refresh(150);
    assertEquals(Math.toRadians(20), position().get(0), 1e-12);
    presenter.jog().release();
    presenter.goals().joints().reset();
    refresh(1);
    assertEquals(Optional.empty(), ghosts.getLast());
  }

  @Test
  void theGhostOfAGoalIsHiddenWithItAndGoesWhenItIsDiscarded() {
    refresh(1);
    presenter.goals().joints().type(0, "20");
    refresh(1);
    presenter.goals().hide();
    assertEquals(Optional.empty(), ghosts.getLast());
    refresh(1);
    assertTrue(ghosts.getLast().isPresent());
    presenter.goals().discard();
    assertEquals(Optional.empty(), ghosts.getLast());
    refresh(1);
    assertEquals(Optional.empty(), ghosts.getLast());
    assertFalse(presenter.goals().joints().edited());
  }

  @Test
  void aJointBeyondItsRangeIsToldAtItsFieldInTheUnitShown() {
    refresh(1);
    presenter.goals().joints().type(2, "400");
    assertEquals("must be -363.000 to 363.000 deg", presenter.goals().joints().problem(2));
    sent.clear();
    presenter.holdJointGoal();
    assertEquals(List.of(), sent);
  }

  @Test
  void aTypedPoseIsGoneTo() {
    refresh(1);
    Pose goal = controller.state().arm().targetTcpInBase();
    presenter.goals().pose().type(2, "600 mm");
    refresh(1);
    assertTrue(presenter.goals().poseReachable(), presenter.goals().poseText());
    presenter.holdPoseGoal();
    refresh(200);
    Pose reached = controller.state().arm().targetTcpInBase();
    assertEquals(0.6, reached.z(), 1e-6);
    assertEquals(0, Poses.distance(goal.with(2, 0.6), reached), 1e-4);
  }

  @Test
  void anUnreachablePoseIsExplained() {
    refresh(1);
    presenter.goals().pose().type(0, "3 m");
    refresh(1);
    assertEquals(
        "The arm cannot reach this pose: farther than the stretched arm reaches",
        presenter.goals().poseText());
    assertEquals(Optional.empty(), ghosts.isEmpty() ? Optional.empty() : ghosts.getLast());
    sent.clear();
    presenter.holdPoseGoal();
    assertEquals(List.of(), sent);
  }

  @Test
  void aPoseCloseToASingularityIsToldButGoneTo() {
    Joints straightWrist = BoxSetup.START_RAD.with(4, 0.001);
    controller = new Controller(ControllerOptions.headless().withStart(straightWrist));
    refresh(1);
    presenter.goals().pose().type(0, presenter.goals().pose().text(0));
    refresh(1);
    assertTrue(presenter.goals().poseText().startsWith("Close to the wrist singularity"));
    assertTrue(presenter.goals().poseReachable());
  }

  @Test
  void aFormIsKeptForTheNextStartAndShowsTheSamePose() {
    refresh(1);
    presenter.goals().pose().type(0, "400");
    Pose before = presenter.form().pose(presenter.goals().pose().values());
    PoseForm form = new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.ROLL_PITCH_YAW);
    presenter.setForm(form);
    assertEquals("15.7480", presenter.goals().pose().text(0));
    assertEquals(0, Poses.distance(before, form.pose(presenter.goals().pose().values())), 1e-9);
    assertEquals("-1.57080", presenter.goals().joints().text(1));
    presenter = presenter();
    assertEquals(form, presenter.form());
  }

  @Test
  void anAlignedToolPointsAlongAnAxis() {
    controller =
        new Controller(ControllerOptions.headless().withStart(BoxSetup.START_RAD.with(3, -1.4)));
    refresh(1);
    presenter.holdAlignment();
    refresh(150);
    Pose tcp = controller.state().arm().targetTcpInBase();
    assertEquals(0, Poses.distance(tcp, ToolAlignment.nearest(tcp)), 1e-6);
  }

  @Test
  void homeIsWhereARobotIsSwitchedOn() {
    controller =
        new Controller(ControllerOptions.headless().withStart(BoxSetup.START_RAD.with(0, 0.2)));
    refresh(1);
    presenter.holdHome();
    refresh(150);
    assertEquals(BoxSetup.START_RAD, position());
  }

  @Test
  void theToolCentreIsTypedAndSet() {
    refresh(1);
    presenter.tool().tcp().type(2, "120 mm");
    presenter.tool().setTcp("gripper");
    refresh(2);
    assertEquals(0.12, controller.state().arm().tool().inFlange().z(), 1e-12);
    assertEquals("gripper", presenter.tool().tcpName());
    assertFalse(presenter.tool().tcp().edited());
    assertEquals("120.00", presenter.tool().tcp().text(2));
  }

  @Test
  void thePayloadIsTypedCheckedAndSet() {
    refresh(1);
    Draft payload = presenter.tool().payload();
    payload.type(0, "-1");
    assertEquals("the mass must be at least 0 kg", presenter.tool().payloadProblem());
    payload.type(0, "6");
    assertTrue(presenter.tool().payloadProblem().startsWith("More than the 5.0 kg"));
    payload.type(0, "60");
    presenter.tool().setPayload();
    refresh(1);
    assertEquals(
        "the mass is 60 kg, must be 0 to 20 kg on UR5e", presenter.tool().payloadProblem());
    payload.type(0, "1500 g");
    presenter.tool().setPayload();
    refresh(2);
    assertEquals(1.5, controller.state().readings().payload().massKg());
    assertEquals("", presenter.tool().payloadProblem());
  }

  @Test
  void whyTheArmWentNoFurtherStaysToBeRead() {
    refresh(1);
    presenter.jog().setSpeedFraction(1);
    presenter.jog().turn(2, -1);
    refresh(300);
    presenter.jog().release();
    refresh(5);
    assertEquals("joint 2 is at the end of its range", presenter.jog().reason());
    presenter.jog().turn(2, 1);
    assertEquals("", presenter.jog().reason());
  }

  @Test
  void rangesAreThoseOfTheSafetyLimitsThatHoldNow() {
    refresh(1);
    SafetyConfiguration standard = controller.safety();
    SafetyConfiguration narrow =
        standard.withLimits(from(standard.normal(), -3), from(standard.reduced(), -2));
    Installation narrowed = Installation.NONE.withSafety(Optional.of(narrow));
    var _ = controller.submit(new InstallationCommand.ApplyInstallation(narrowed));
    refresh(1);
    assertEquals(-3, presenter.range(2).minRad());
    var _ = controller.submit(new SafetyCommand.SetSafetyInput(SafetyInput.REDUCED_MODE, true));
    refresh(10);
    assertEquals(-2, presenter.range(2).minRad());
  }

  /** With another end of the range of the elbow, rad. */
  private static SafetyLimits from(SafetyLimits limits, double minRad) {
    return new SafetyLimits(
        limits.powerW(),
        limits.momentumKgMPerS(),
        limits.stoppingTimeS(),
        limits.stoppingDistanceM(),
        limits.toolSpeedMPerS(),
        limits.toolForceN(),
        limits.elbowSpeedMPerS(),
        limits.elbowForceN(),
        limits.jointSpeedRadPerS(),
        limits.jointMinRad().with(2, minRad),
        limits.jointMaxRad());
  }

  @Test
  void poseAndJointsOfAGoalBelongTogether() {
    refresh(1);
    presenter.goals().joints().type(0, "90");
    refresh(1);
    Pose there =
        controller
            .state()
            .arm()
            .kinematics()
            .tcpPose(BoxSetup.START_RAD.with(0, Math.PI / 2), Pose.ZERO);
    assertEquals(there.x(), presenter.goals().pose().values()[0], 1e-9);
    presenter.goals().pose().type(2, "600");
    assertFalse(presenter.goals().joints().edited(), "typed in one, forgotten in the other");
    refresh(1);
    Joints q = Joints.of(presenter.goals().joints().values());
    assertEquals(0.6, controller.state().arm().kinematics().tcpPose(q, Pose.ZERO).z(), 1e-6);
    presenter.goals().pose().reset();
    refresh(1);
    assertEquals("0.000", presenter.goals().joints().text(0));
  }

  @Test
  void homeIsSetToHereAndKeptForThisKindOfRobot() {
    controller =
        new Controller(ControllerOptions.headless().withStart(BoxSetup.START_RAD.with(0, 0.2)));
    refresh(1);
    presenter.setHomeHere();
    presenter = presenter();
    assertEquals(BoxSetup.START_RAD.with(0, 0.2), presenter.home().homeRad());
    ArmDescription other = ArmLibrary.load("ur10e");
    presenter.setArm(other);
    assertEquals(BoxSetup.START_RAD, presenter.home().homeRad());
  }

  @Test
  void homeIsTypedWithinTheRanges() {
    refresh(1);
    presenter.home().draft().type(0, "400");
    presenter.home().setTyped();
    assertTrue(presenter.home().standard());
    assertEquals("must be -363.000 to 363.000 deg", presenter.home().draft().problem(0));
    presenter.home().draft().type(0, "10");
    presenter.home().setTyped();
    presenter.holdHome();
    refresh(100);
    assertEquals(Math.toRadians(10), position().get(0), 1e-12);
  }

  @Test
  void aFrameOfPeoplesOwnLeadsTheToolAndShowsPoses() {
    refresh(1);
    presenter.frame().draft().type(5, "90");
    presenter.frame().setTyped();
    presenter.jog().setAxes(JogAxes.FRAME);
    Pose before = controller.state().arm().targetTcpInBase();
    refresh(1);
    assertEquals(before.y(), presenter.goals().pose().values()[0], 1e-9, "x there is y here");
    presenter.jog().setSize(JogSize.COARSE);
    presenter.jog().move(JogDirection.along(1, 0, 0));
    refresh(100);
    assertEquals(before.y() + 0.01, controller.state().arm().targetTcpInBase().y(), 1e-6);
    presenter = presenter();
    assertEquals(Math.PI / 2, presenter.frame().inBase().rz(), 1e-12, "kept");
  }

  @Test
  void aPoseTypedInTheFrameIsGoneToThere() {
    refresh(1);
    presenter.frame().set(new Pose(0.1, 0, 0, 0, 0, 0));
    presenter.jog().setAxes(JogAxes.FRAME);
    refresh(1);
    presenter.goals().pose().type(0, "300");
    refresh(1);
    presenter.holdPoseGoal();
    refresh(250);
    assertEquals(0.4, controller.state().arm().targetTcpInBase().x(), 1e-6);
  }

  @Test
  void namedToolsAreKeptAndShownAgain() {
    refresh(1);
    ToolPresenter tool = presenter.tool();
    assertEquals("Give the TCP a name to keep it.", tool.keep(" "));
    tool.tcp().type(2, "150");
    assertEquals("", tool.keep("gripper"));
    tool.resetTcp();
    presenter = presenter();
    refresh(1);
    assertEquals(List.of("gripper"), presenter.tool().named().names());
    presenter.tool().choose("gripper");
    assertEquals("150.00", presenter.tool().tcp().text(2));
    presenter.tool().named().forget("gripper");
    assertEquals(List.of(), presenter().tool().named().names());
  }

  @Test
  void settingsThatWereSpoiledByHandAreSkipped() {
    remembered.put("move.home.ur5e", "1 2 x");
    remembered.put("move.frame", "nan");
    remembered.put("move.tcps", "good\t0 0 0.1 0 0 0\nbad\t1 2\n\t");
    remembered.put("move.speed", "fast");
    presenter = presenter();
    assertTrue(presenter.home().standard());
    assertEquals(Pose.ZERO, presenter.frame().inBase());
    assertEquals(List.of("good"), presenter.tool().named().names());
    assertEquals(0.5, presenter.jog().speedFraction());
  }

  @Test
  void theInertiaIsCheckedAndDeclared() {
    refresh(1);
    Draft payload = presenter.tool().payload();
    payload.type(0, "2");
    payload.type(ToolPresenter.INERTIA, "-1");
    assertTrue(presenter.tool().payloadProblem().contains("at least 0"));
    payload.type(ToolPresenter.INERTIA, "0.01");
    payload.type(ToolPresenter.INERTIA + 3, "5");
    assertTrue(presenter.tool().payloadProblem().startsWith("Inertia: no body has it"));
    payload.type(ToolPresenter.INERTIA + 3, "0");
    assertEquals("", presenter.tool().payloadProblem());
    presenter.tool().setPayload();
    refresh(2);
    assertEquals(0.01, controller.state().readings().payload().ixx());
    assertEquals(2, controller.state().readings().payload().massKg());
  }

  @Test
  void safetyLimitsNarrowTheRangesThatAreShown() {
    ArmDescription arm = ArmLibrary.load("ur5e");
    JointRange range = JointRange.of(arm.joints().get(0), -1, 2);
    assertEquals(new JointRange(-1, 2, false), range);
    assertEquals(
        presenter.range(0).maxRad(),
        2 * Math.PI + Math.toRadians(3),
        1e-12,
        "the arm's own where they are wider");
  }
}
