package org.pendant.gui.move;

import java.util.Collections;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.pendant.controller.Command;
import org.pendant.controller.Pace;
import org.pendant.controller.Reply;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.jog.JogDirection;
import org.pendant.controller.jog.JogFrame;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.workbench.Settings;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;

/** What the screen that moves the arm shows and does. One thread uses it. */
final class MovePresenter {
  private static final Reach NOTHING_TYPED = new Reach(Optional.empty(), "");

  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Settings settings;
  private final GhostArm ghost;
  private final JogHold hold;
  private final Draft joints;
  private final Draft pose;
  private final ToolPresenter tool;
  private PoseForm form;
  private ArmDescription arm;
  private InverseKinematics inverse;
  private double speedFraction = 0.5;
  private JogFrame frame = JogFrame.BASE;
  private Optional<ControllerState> state = Optional.empty();
  private Optional<Obstacle> obstacle = Optional.empty();
  private Reach reach = NOTHING_TYPED;
  private Optional<Joints> ghostRad = Optional.empty();

  /**
   * A screen that has seen nothing.
   *
   * @param submit hands commands to the controller
   * @param executor runs what replies lead to in the thread that uses this object
   * @param settings remembers units
   * @param arm what is moved
   * @param ghost shows goals
   */
  MovePresenter(
      Function<Command, CompletableFuture<Reply>> submit,
      Executor executor,
      Settings settings,
      ArmDescription arm,
      GhostArm ghost) {
    this.submit = submit;
    this.settings = settings;
    this.ghost = ghost;
    this.arm = arm;
    hold = new JogHold(submit, executor);
    inverse = new InverseKinematics(arm);
    form = FormMemory.read(settings);
    joints = new Draft(Collections.nCopies(Joints.COUNT, form.angle()), this::jointProblem);
    pose = new Draft(form.units(), (index, value) -> Optional.empty());
    tool = new ToolPresenter(submit, executor, arm, form);
  }

  private Optional<String> jointProblem(int joint, double positionRad) {
    JointRange range = range(joint);
    return range.contains(positionRad)
        ? Optional.empty()
        : Optional.of(
            "must be "
                + form.angle().text(range.minRad())
                + " to "
                + form.angle().text(range.maxRad())
                + " "
                + form.angle().symbol());
  }

  /** Another robot has been switched on. */
  void setArm(ArmDescription other) {
    release();
    arm = other;
    inverse = new InverseKinematics(other);
    joints.reset();
    pose.reset();
    tool.setArm(other);
  }

  /** Takes the newest snapshot, and repeats what is held; about 30 times a second. */
  void take(ControllerState newest, Pace pace) {
    state = Optional.of(newest);
    obstacle = Obstacle.of(newest, pace);
    if (obstacle.isPresent()) {
      hold.release();
    } else {
      hold.repeat();
    }
    joints.follow(newest.arm().actualPositionRad().toArray());
    pose.follow(form.numbers(newest.arm().actualTcpInBase()));
    tool.take(newest);
    reach = pose.edited() && pose.valid() ? reach(newest) : NOTHING_TYPED;
    showGhost();
  }

  private Reach reach(ControllerState now) {
    return Reach.of(
        arm, inverse, goal(), now.arm().tool().inFlange(), now.arm().targetPositionRad());
  }

  private void showGhost() {
    Optional<Joints> wanted = reach.q();
    if (wanted.isEmpty() && joints.edited() && joints.valid()) {
      wanted = Optional.of(Joints.of(joints.values()));
    }
    if (!wanted.equals(ghostRad)) {
      ghostRad = wanted;
      ghost.show(wanted);
    }
  }

  /** The pose in the fields. */
  private Pose goal() {
    return form.pose(pose.values());
  }

  /** What keeps the arm from being moved by hand; empty if nothing does. */
  Optional<Obstacle> obstacle() {
    return obstacle;
  }

  /** Whether buttons that move the arm can be pressed. */
  boolean movable() {
    return state.isPresent() && obstacle.isEmpty();
  }

  /** Does what the button beside the obstacle says. */
  void removeObstacle() {
    obstacle.flatMap(Obstacle::command).ifPresent(this::send);
  }

  private void send(Command command) {
    var _ = submit.apply(command);
  }

  /** Begins to turn a joint (0 to 5) up (1) or down (-1). */
  void holdJoint(int joint, int direction) {
    press(new JogMove.TurnJoint(joint, direction));
  }

  /** Begins to move or turn the tool along or about an axis of the chosen frame. */
  void holdTool(JogDirection direction) {
    press(new JogMove.MoveTool(direction, frame));
  }

  /** Begins to move to the joint positions that were typed. */
  void holdJointGoal() {
    if (joints.edited() && joints.valid()) {
      press(new JogMove.ToJoints(Joints.of(joints.values())));
    }
  }

  /** Begins to move to the pose that was typed. */
  void holdPoseGoal() {
    if (pose.edited() && reach.q().isPresent()) {
      press(new JogMove.ToPose(goal()));
    }
  }

  /** Begins to move to where a robot is when it is switched on. */
  void holdHome() {
    press(new JogMove.ToJoints(BoxSetup.START_RAD));
  }

  /** Begins to turn the tool parallel to the nearest axis of the base. */
  void holdAlignment() {
    state.ifPresent(
        now -> press(new JogMove.StraightTo(ToolAlignment.nearest(now.arm().targetTcpInBase()))));
  }

  private void press(JogMove move) {
    if (movable()) {
      hold.press(move, speedFraction);
    }
  }

  /** Whatever was held is let go. */
  void release() {
    hold.release();
  }

  /** Why the arm did not do what was held last, or not any further; empty if it did. */
  String jogReason() {
    return hold.reason();
  }

  /** Speed of moves that begin from now on; see {@link Command.Jog}. */
  void setSpeedFraction(double fraction) {
    speedFraction = fraction;
  }

  double speedFraction() {
    return speedFraction;
  }

  /** Along whose axes the tool moves from now on. */
  void setFrame(JogFrame other) {
    release();
    frame = other;
  }

  /** Shows all numbers in another form. */
  void setForm(PoseForm other) {
    pose.convert(other.units(), other.numbers(goal()));
    tool.setForm(other);
    PoseForm before = form;
    form = other;
    if (before.angle() != other.angle()) {
      joints.convert(Collections.nCopies(Joints.COUNT, other.angle()), joints.values());
    }
    FormMemory.write(settings, other);
  }

  PoseForm form() {
    return form;
  }

  /** Joint positions, of the arm or as typed. */
  Draft joints() {
    return joints;
  }

  /** The pose of the TCP in the base frame, of the arm or as typed. */
  Draft pose() {
    return pose;
  }

  /** The TCP and the payload. */
  ToolPresenter tool() {
    return tool;
  }

  /** Whether the pose that was typed can be gone to. */
  boolean poseReachable() {
    return reach.q().isPresent();
  }

  /** What is to be said of the pose that was typed; empty if nothing. */
  String poseText() {
    return pose.problem().isEmpty() ? reach.text() : "";
  }

  JointRange range(int joint) {
    return JointRange.of(arm.joints().get(joint));
  }

  /** Where a joint is, rad. */
  double positionRad(int joint) {
    return state.map(now -> now.arm().actualPositionRad().get(joint)).orElse(0.0);
  }

  /** The joint positions of the arm as URScript. */
  String jointsScript() {
    return state.map(now -> ScriptText.of(now.arm().targetPositionRad())).orElse("");
  }

  /** The pose of the TCP as URScript. */
  String poseScript() {
    return state.map(now -> ScriptText.of(now.arm().targetTcpInBase())).orElse("");
  }
}
