package org.pendant.gui.move;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Command;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.jog.JogDirection;
import org.pendant.controller.jog.JogFrame;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.gui.workbench.Settings;
import org.pendant.language.source.Source;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/** The screen that moves the arm, with a controller but without a window. */
final class MovePresenterTest {
  private static final int FRAMES_A_REFRESH = 17;

  private final Map<String, String> remembered = new HashMap<>();
  private final Settings settings =
      new Settings() {
        @Override
        public Optional<String> get(String name) {
          return Optional.ofNullable(remembered.get(name));
        }

        @Override
        public void put(String name, String text) {
          remembered.put(name, text);
        }
      };
  private final List<Command> sent = new ArrayList<>();
  private final List<Optional<Joints>> ghosts = new ArrayList<>();
  private Controller controller = new Controller(ControllerOptions.headless());
  private MovePresenter presenter = presenter();

  private MovePresenter presenter() {
    return new MovePresenter(
        command -> {
          sent.add(command);
          return controller.submit(command);
        },
        Runnable::run,
        settings,
        ArmLibrary.load("ur5e"),
        ghosts::add);
  }

  private void refresh(int times) {
    for (int i = 0; i < times; i++) {
      controller.runUntil(() -> false, FRAMES_A_REFRESH);
      presenter.take(controller.state(), Pace.REAL_TIME);
    }
  }

  private String obstacle() {
    return presenter.obstacle().map(Obstacle::text).orElse("");
  }

  private Joints position() {
    return controller.state().arm().targetPositionRad();
  }

  @Test
  void aHeldJointTurnsUntilItIsLetGo() {
    refresh(1);
    presenter.holdJoint(0, 1);
    refresh(60);
    assertTrue(position().get(0) > 0.2, "at " + position().get(0));
    presenter.release();
    refresh(20);
    Joints rest = position();
    refresh(20);
    assertEquals(rest, position());
  }

  @Test
  void aScreenThatIsNoLongerRefreshedMovesNothing() {
    refresh(1);
    presenter.holdJoint(0, 1);
    refresh(20);
    controller.runUntil(() -> false, 300);
    assertEquals(Joints.ZERO, controller.state().arm().targetSpeedRadPerS());
  }

  @Test
  void theToolMovesAlongTheChosenAxesAtTheChosenSpeed() {
    refresh(1);
    presenter.setFrame(JogFrame.TOOL);
    presenter.setSpeedFraction(0.2);
    JogDirection up = JogDirection.along(0, 0, 1);
    presenter.holdTool(up);
    assertEquals(new Command.Jog(new JogMove.MoveTool(up, JogFrame.TOOL), 0.2), sent.getLast());
  }

  @Test
  void anArmThatIsOffIsOfferedToBeSwitchedOn() {
    controller = new Controller(ControllerOptions.headless().withPower(false));
    refresh(1);
    assertFalse(presenter.movable());
    assertEquals("Power off: the arm cannot be moved.", obstacle());
    presenter.holdJoint(0, 1);
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
            new Command.StartProgram(
                controller
                    .load(
                        Source.of(
                            "t",
                            "def p():\n sleep(9)\nend\n".getBytes(StandardCharsets.ISO_8859_1)))
                    .program()
                    .orElseThrow()));
    refresh(1);
    assertEquals("Program p is running. Stop it to move the arm by hand.", obstacle());
    presenter.removeObstacle();
    refresh(1);
    assertEquals("", obstacle());
  }

  @Test
  void aStopThatComesWhileAButtonIsHeldLetsItGo() {
    refresh(1);
    presenter.holdJoint(0, 1);
    refresh(20);
    var _ = controller.submit(new Command.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    refresh(2);
    assertEquals(new Command.StopJog(), sent.getLast());
    assertTrue(obstacle().startsWith("Safeguard stop."), obstacle());
  }

  @Test
  void timeMustGoByAtAPaceThatHandsCanFollow() {
    refresh(1);
    presenter.take(controller.state(), new Pace.Paused());
    assertEquals("Robot time is paused. Let it go on to move the arm by hand.", obstacle());
    presenter.take(controller.state(), new Pace.Times(5));
    assertTrue(obstacle().contains("at most 4 times"), obstacle());
    presenter.take(controller.state(), new Pace.Times(4));
    assertEquals("", obstacle());
  }

  @Test
  void aSliderAtZeroIsTold() {
    var _ = controller.submit(new Command.SetSpeedFraction(0));
    refresh(1);
    assertEquals("The speed slider is at 0 %, which holds the arm. Move it up.", obstacle());
  }

  @Test
  void typedJointsAreGoneToAndShownAsAGhost() {
    refresh(1);
    presenter.joints().type(0, "20");
    refresh(1);
    assertEquals(Math.toRadians(20), ghosts.getLast().orElseThrow().get(0), 1e-12);
    presenter.holdJointGoal();
    refresh(150);
    assertEquals(Math.toRadians(20), position().get(0), 1e-12);
    presenter.release();
    presenter.joints().reset();
    refresh(1);
    assertEquals(Optional.empty(), ghosts.getLast());
  }

  @Test
  void aJointBeyondItsRangeIsToldAtItsFieldInTheUnitShown() {
    refresh(1);
    presenter.joints().type(2, "400");
    assertEquals("must be -360.000 to 360.000 deg", presenter.joints().problem(2));
    sent.clear();
    presenter.holdJointGoal();
    assertEquals(List.of(), sent);
  }

  @Test
  void aTypedPoseIsGoneTo() {
    refresh(1);
    Pose goal = controller.state().arm().targetTcpInBase();
    presenter.pose().type(2, "600 mm");
    refresh(1);
    assertTrue(presenter.poseReachable(), presenter.poseText());
    presenter.holdPoseGoal();
    refresh(200);
    Pose reached = controller.state().arm().targetTcpInBase();
    assertEquals(0.6, reached.z(), 1e-6);
    assertEquals(0, Poses.distance(goal.with(2, 0.6), reached), 1e-4);
  }

  @Test
  void anUnreachablePoseIsExplained() {
    refresh(1);
    presenter.pose().type(0, "3 m");
    refresh(1);
    assertEquals(
        "The arm cannot reach this pose: farther than the stretched arm reaches",
        presenter.poseText());
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
    presenter.pose().type(0, presenter.pose().text(0));
    refresh(1);
    assertTrue(presenter.poseText().startsWith("Close to the wrist singularity"));
    assertTrue(presenter.poseReachable());
  }

  @Test
  void aFormIsKeptForTheNextStartAndShowsTheSamePose() {
    refresh(1);
    presenter.pose().type(0, "400");
    Pose before = presenter.form().pose(presenter.pose().values());
    PoseForm form = new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.ROLL_PITCH_YAW);
    presenter.setForm(form);
    assertEquals("15.7480", presenter.pose().text(0));
    assertEquals(0, Poses.distance(before, form.pose(presenter.pose().values())), 1e-9);
    assertEquals("-1.57080", presenter.joints().text(1));
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
    presenter.tool().setTcp();
    refresh(2);
    assertEquals(0.12, controller.state().arm().tool().inFlange().z(), 1e-12);
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
        "the mass is 60 kg, must be 0 to 20 kg on ur5e", presenter.tool().payloadProblem());
    payload.type(0, "1500 g");
    presenter.tool().setPayload();
    refresh(2);
    assertEquals(1.5, controller.state().readings().payload().massKg());
    assertEquals("", presenter.tool().payloadProblem());
  }

  @Test
  void whyTheArmWentNoFurtherStaysToBeRead() {
    refresh(1);
    presenter.setSpeedFraction(1);
    presenter.holdJoint(2, -1);
    refresh(300);
    presenter.release();
    refresh(5);
    assertEquals("joint 2 is at the end of its range", presenter.jogReason());
    presenter.holdJoint(2, 1);
    assertEquals("", presenter.jogReason());
  }
}
