package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.function.Supplier;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.Pace;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.settings.Settings;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * Move presenter: what the screen that moves the arm shows and does: its parts, and what concerns
 * several of them. One thread uses it.
 */
final class MovePresenter {
  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Settings settings;
  private final JogPresenter jog;
  private final FreedrivePresenter freedrive;
  private final GoalPresenter goals;
  private final HomePresenter home;
  private final FramePresenter frame;
  private final ToolPresenter tool;
  private PoseForm form;
  private ArmDescription arm;
  private final Supplier<SafetyConfiguration> safety;
  private Optional<ControllerState> state = Optional.empty();
  private Optional<Obstacle> obstacle = Optional.empty();

  /**
   * A screen that has seen nothing.
   *
   * @param submit hands commands to the controller
   * @param executor runs what replies lead to in the thread that uses this object
   * @param settings remembers units, home, frame and TCPs
   * @param arm what is moved
   * @param safety what holds now; it limits the joints, too
   * @param ghost shows goals
   */
  MovePresenter(
      Function<Command, CompletableFuture<Reply>> submit,
      Executor executor,
      Settings settings,
      ArmDescription arm,
      Supplier<SafetyConfiguration> safety,
      GhostArm ghost) {
    this.submit = submit;
    this.settings = settings;
    this.arm = arm;
    this.safety = safety;
    form = FormMemory.read(settings);
    jog = new JogPresenter(new JogHold(submit, executor), settings, form, this::range);
    freedrive =
        new FreedrivePresenter(
            new RepeatedCommand(submit, executor, new ManualCommand.EndFreedrive()));
    goals = new GoalPresenter(arm, form, ghost, this::jointProblem);
    home = new HomePresenter(settings, arm.id(), form.angle(), this::jointProblem);
    frame = new FramePresenter(settings, form);
    tool = new ToolPresenter(submit, executor, arm, form, new NamedTools(settings));
  }

  private Optional<String> jointProblem(int joint, double positionRad) {
    JointRange range = range(joint);
    return range.contains(positionRad)
        ? Optional.empty()
        : Optional.of(
            text(
                "jointOutside",
                form.angle().text(range.minRad()),
                form.angle().text(range.maxRad()),
                form.angle().symbol()));
  }

  /** Another robot has been switched on. */
  void setArm(ArmDescription other) {
    jog.release();
    freedrive.release();
    arm = other;
    goals.setArm(other);
    home.setRobot(other.id());
    tool.setArm(other);
  }

  /** Takes the newest snapshot, and repeats what is held; about 30 times a second. */
  void take(ControllerState newest, Pace pace) {
    PoseForm chosen = FormMemory.read(settings);
    if (!chosen.equals(form)) {
      // by another screen
      follow(chosen);
    }
    state = Optional.of(newest);
    obstacle = Obstacle.of(newest, pace);
    jog.setFrame(frame.inBase());
    jog.take(newest, obstacle.isEmpty());
    freedrive.setFrame(frame.inBase());
    freedrive.take(newest, obstacle.isEmpty());
    goals.setFrame(shownFrameInBase());
    goals.take(newest);
    tool.take(newest);
  }

  /** What keeps the arm from being moved by hand; empty if nothing does. */
  Optional<Obstacle> obstacle() {
    return obstacle;
  }

  /** Whether buttons that move the arm can be pressed. */
  boolean movable() {
    return jog.movable();
  }

  /** Does what the button beside the obstacle says. */
  void removeObstacle() {
    obstacle
        .flatMap(Obstacle::command)
        .ifPresent(
            command -> {
              var _ = submit.apply(command);
            });
  }

  /** Begins to move to the joint positions that were typed. */
  void holdJointGoal() {
    goals.typedJoints().ifPresent(q -> jog.go(new JogMove.ToJoints(q)));
  }

  /** Begins to move to the pose that was typed. */
  void holdPoseGoal() {
    goals.typedPoseInBase().ifPresent(tcp -> jog.go(new JogMove.ToPose(tcp)));
  }

  /** Begins to move home. */
  void holdHome() {
    jog.go(new JogMove.ToJoints(home.homeRad()));
  }

  /** Home is where the arm should be now, from now on. */
  void setHomeHere() {
    state.ifPresent(now -> home.set(now.arm().targetPositionRad()));
  }

  /** The frame is at the TCP from now on. */
  void setFrameHere() {
    state.ifPresent(now -> frame.set(now.arm().targetTcpInBase()));
  }

  /** Begins to turn the tool parallel to the nearest axis of base or frame. */
  void holdAlignment() {
    state.ifPresent(
        now -> {
          Pose tcp = now.arm().targetTcpInBase();
          Pose inFrame = Poses.trans(Poses.inverse(shownFrameInBase()), tcp);
          Pose aligned = Poses.trans(shownFrameInBase(), ToolAlignment.nearest(inFrame));
          Pose turned =
              new Pose(tcp.x(), tcp.y(), tcp.z(), aligned.rx(), aligned.ry(), aligned.rz());
          jog.go(new JogMove.StraightTo(turned));
        });
  }

  /** The frame in which poses are shown: people's own while moves follow its axes. */
  private Pose shownFrameInBase() {
    return jog.axes() == JogAxes.FRAME ? frame.inBase() : Pose.ZERO;
  }

  /** Shows all numbers in another form. */
  void setForm(PoseForm other) {
    FormMemory.write(settings, other);
    follow(other);
  }

  private void follow(PoseForm other) {
    jog.setForm(other);
    goals.setForm(other);
    tool.setForm(other);
    frame.setForm(other);
    form = other;
    home.setAngle(other.angle());
  }

  PoseForm form() {
    return form;
  }

  /** Moves by button. */
  JogPresenter jog() {
    return jog;
  }

  /** Guiding by hand. */
  FreedrivePresenter freedrive() {
    return freedrive;
  }

  /** Joint positions and pose, and what is typed there. */
  GoalPresenter goals() {
    return goals;
  }

  /** Where home is. */
  HomePresenter home() {
    return home;
  }

  /** The frame of people's own. */
  FramePresenter frame() {
    return frame;
  }

  /** The TCP and the payload. */
  ToolPresenter tool() {
    return tool;
  }

  /** What arm and safety limits leave to a joint, 0 to 5. */
  JointRange range(int joint) {
    boolean reduced = state.map(now -> now.safety().reduced()).orElse(false);
    SafetyLimits limits = reduced ? safety.get().reduced() : safety.get().normal();
    return JointRange.of(
        arm.joints().get(joint), limits.jointMinRad().get(joint), limits.jointMaxRad().get(joint));
  }

  /** Where a joint is, rad. */
  double positionRad(int joint) {
    return state.map(now -> now.arm().actualPositionRad().get(joint)).orElse(0.0);
  }

  /** The joint positions of the arm as URScript. */
  String jointsScript() {
    return state.map(now -> PositionText.of(now.arm().targetPositionRad())).orElse("");
  }

  /** The pose of the TCP in the base as URScript. */
  String poseScript() {
    return state.map(now -> PositionText.of(now.arm().targetTcpInBase())).orElse("");
  }
}
