package org.pendant.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.safety.SpeedCaps;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Wrench;
import org.pendant.motion.ArcRoute;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.Move;
import org.pendant.motion.MoveLimits;
import org.pendant.motion.PathLimiter;
import org.pendant.motion.PathLimits;
import org.pendant.motion.PlanningException;
import org.pendant.motion.Routes;
import org.pendant.motion.StopJ;
import org.pendant.motion.StopL;
import org.pendant.motion.force.ForceAxis;
import org.pendant.motion.force.ForceMode;
import org.pendant.motion.force.ForceTask;
import org.pendant.motion.force.FrameKind;
import org.pendant.motion.offset.OffsetType;
import org.pendant.motion.toolpath.RunPlan;
import org.pendant.motion.toolpath.ToolConfiguration;
import org.pendant.motion.toolpath.Toolpaths;

/**
 * A motion of a UR5e that continues for a hundred thousand frames and more without anything being
 * planned: it is as slow as that takes, which makes its frames no cheaper. What counts is the
 * target alone, with all that limits it; no arm follows it.
 */
public final class SteadyMotion {
  /** What moves the arm. */
  public enum Kind {
    MOVEJ,
    MOVEL,
    MOVEC,
    MOVEP,
    /** A process move round a waypoint on an arc. */
    MOVEP_CORNER,
    BLEND_JOINTS,
    BLEND_LINES,
    BLEND_MIXED,
    OPTIMOVEJ,
    OPTIMOVEL,
    /** A line that the limit of the tool's speed slows down in every frame. */
    SLOWED_DOWN,
    SPEEDJ,
    SPEEDL,
    SERVOJ,
    SERVOC,
    DIRECT_TORQUE,
    FREEDRIVE,
    FORCE_POINT,
    FORCE_FIXED,
    FORCE_MOTION,
    FORCE_TOOL,
    /** Giving way is slowed down in every frame because the arm would be too fast. */
    FORCE_AT_LIMIT,
    CONVEYOR_LINEAR,
    CONVEYOR_CIRCULAR,
    PATH_OFFSET,
    TOOLPATH,
    TOOLPATH_REMOTE,
    TOOLPATH_FREE,
    STOPJ,
    STOPL,
    PAUSE
  }

  /** The longest that one continues before it begins anew, frames. */
  private static final int LONGEST = 200_000;

  /** Frames in which something that sways goes one way. */
  private static final int SWAY = 200;

  private static final Joints READY = BoxSetup.START_RAD;
  private static final Pose TCP = new Pose(0.01, -0.02, 0.12, 0.1, -0.3, 0.2);

  /** For moves of the tool: a metre takes two hours. */
  private static final MoveLimits SLOWLY = new MoveLimits(1, 1e-4, 0);

  private static final MoveLimits AS_FAST_AS_POSSIBLE = new MoveLimits(1e9, 1e9, 0);
  private static final double RADIUS_M = 0.04;
  private static final double JERK_RAMP_S = 0.08;

  private static final Wrench PUSH = new Wrench(3, 2, 4, 0.1, -0.1, 0.05);
  private static final Wrench PULL = new Wrench(-3, -2, -4, -0.1, 0.1, -0.05);

  /** A part of what an arm may do otherwise. */
  private record Stricter(PathLimiter usual, double share, double most) implements PathLimiter {
    @Override
    public double largestScaling(double[] q, double[] qd) {
      return Math.min(most, share * usual.largestScaling(q, qd));
    }

    @Override
    public double largestScaling(double[] q, double[] qd, double[][] frames) {
      return Math.min(most, share * usual.largestScaling(q, qd, frames));
    }
  }

  private final Kind kind;
  private final ArmDescription arm;
  private final ForwardKinematics forward;
  private final Optional<RunPlan> run;
  private final ControlBox box = new ControlBox(BoxSetup.headless("ur5e"));
  private final MotionControl motion;
  private final ForceMode force;
  private Wrench felt = PUSH;
  private int frame;

  SteadyMotion(Kind kind) throws PlanningException {
    this.kind = kind;
    arm = box.arm().description();
    forward = box.kinematics().forward();
    box.flange().setTool(new ToolCentre(TCP, "tool"));
    SpeedCaps caps = new SpeedCaps(arm, box.arm().model().dynamics(), box.safety());
    caps.setTool(TCP);
    motion =
        kind == Kind.SLOWED_DOWN
            ? new MotionControl(arm, READY, new Stricter(caps, 1, 0.5))
            : box.motion();
    PathLimiter givingWay =
        kind == Kind.FORCE_AT_LIMIT ? new Stricter(caps, 0.01, Double.POSITIVE_INFINITY) : caps;
    force =
        new ForceMode(
            new ForceMode.Setup(
                arm,
                box.arm().simulated(),
                () -> felt,
                givingWay,
                box.safety()::limits,
                box.motion()));
    force.setTool(TCP);
    run =
        switch (kind) {
          case TOOLPATH, TOOLPATH_REMOTE, TOOLPATH_FREE -> Optional.of(toolpath());
          default -> Optional.empty();
        };
    begin();
  }

  /** One frame. */
  void frame() throws PlanningException {
    if (++frame == LONGEST) {
      begin();
    }
    prepare();
    box.offsets().encoders().step(box.signals().digital());
    motion.step();
  }

  /** A number that every frame counts for. */
  double seen() {
    return motion.scaling();
  }

  /** Whether it has continued so far. */
  boolean continues() {
    return motion.fault().isEmpty() && !motion.steady();
  }

  /** What others give in each frame. */
  private void prepare() throws PlanningException {
    boolean turns = frame % SWAY == 0;
    switch (kind) {
      case DIRECT_TORQUE -> motion.giveTorque();
      case FORCE_POINT, FORCE_FIXED, FORCE_MOTION, FORCE_TOOL, FORCE_AT_LIMIT -> {
        if (turns) {
          felt = frame / SWAY % 2 == 0 ? PUSH : PULL;
          box.offsets().encoders().get(0).run(frame / SWAY % 2 == 0 ? 1000 : -1000);
        }
      }
      case CONVEYOR_LINEAR, CONVEYOR_CIRCULAR -> {
        if (turns) {
          box.offsets().encoders().get(0).run(frame / SWAY % 2 == 0 ? 5000 : -5000);
        }
      }
      default -> {}
    }
  }

  private void begin() throws PlanningException {
    frame = 0;
    motion.adopt(READY);
    switch (kind) {
      case MOVEJ -> start(joints(READY.with(0, 0.5).with(4, 1), 0));
      case MOVEL, SLOWED_DOWN, PATH_OFFSET -> line();
      case MOVEC -> start(circle(SLOWLY));
      case MOVEP -> start(process(beside(0.1, 0.1, 0), 0));
      case MOVEP_CORNER ->
          blend(process(beside(0.041, 0, 0), RADIUS_M), process(beside(0.041, 0.1, 0), 0));
      case BLEND_JOINTS -> blend(joints(READY.with(0, 0.07), RADIUS_M), joints(READY, 0));
      case BLEND_LINES ->
          blend(line(beside(0.041, 0, 0), RADIUS_M), line(beside(0.041, 0.1, 0), 0));
      case BLEND_MIXED -> blend(line(beside(0.041, 0, 0), RADIUS_M), joints(READY, 0));
      case OPTIMOVEJ -> {
        Joints goal = new Joints(1, -1, -2, -1.5, 1.2, 0.5);
        PathLimits some = box.planning().limits().share(1e-4, 1, Double.POSITIVE_INFINITY);
        start(
            new Move(
                from -> Routes.joints(arm, from, goal, forward.tcpPose(goal, TCP), TCP, some),
                AS_FAST_AS_POSSIBLE,
                0,
                JERK_RAMP_S));
      }
      case OPTIMOVEL -> {
        PathLimits some = box.planning().limits().share(1e-4, 1, Double.POSITIVE_INFINITY);
        Pose goal = beside(0.1, 0.2, 0.1);
        start(
            new Move(
                from -> Routes.line(arm, from, forward.tcpPose(from, TCP), goal, TCP, some),
                AS_FAST_AS_POSSIBLE,
                0,
                JERK_RAMP_S));
      }
      case SPEEDJ ->
          continueWith(
              box.modes()
                  .servoing()
                  .speedJ(
                      new Joints(1e-4, 2e-4, -1e-4, 0, 1e-4, -2e-4), 1, OptionalDouble.of(1e6)));
      case SPEEDL ->
          continueWith(
              box.modes()
                  .servoing()
                  .speedL(
                      TCP,
                      new double[] {1e-4, 2e-4, 0, 1e-4, 0, 2e-4},
                      1,
                      1,
                      OptionalDouble.of(1e6)));
      case SERVOJ ->
          continueWith(
              box.modes().servoing().servoJ(READY.with(0, 0.5).with(3, -1.2), 1e6, 0.2, 1e-5));
      case SERVOC ->
          continueWith(box.modes().servoing().servoC(beside(0.1, 0.1, 0.05), TCP, 1, 1e-4, 0));
      case DIRECT_TORQUE -> motion.guide(READY, READY);
      case FREEDRIVE -> {
        motion.startGuidance();
        motion.guide(READY, READY);
      }
      case FORCE_POINT -> press(FrameKind.POINT);
      case FORCE_FIXED, FORCE_AT_LIMIT -> press(FrameKind.FIXED);
      case FORCE_MOTION -> press(FrameKind.MOTION);
      case FORCE_TOOL -> press(FrameKind.TOOL);
      case CONVEYOR_LINEAR -> {
        box.offsets()
            .conveyor()
            .trackLinear(new Pose(0, 1, 0, 0, 0, 0), 100_000, box.offsets().encoders().get(0));
        line();
      }
      case CONVEYOR_CIRCULAR -> {
        box.offsets()
            .conveyor()
            .trackCircular(Pose.ZERO, 1_000_000, true, box.offsets().encoders().get(0));
        line();
      }
      case TOOLPATH, TOOLPATH_REMOTE, TOOLPATH_FREE ->
          motion.start((from, speed) -> run.orElseThrow().begin(from));
      case STOPJ -> {
        moveALittle();
        motion.takeOver((q, qd) -> new StopJ(q, new Joints(1e-3, 0, 2e-3, 0, 0, 1e-3), 1e-6));
      }
      case STOPL -> {
        moveALittle();
        motion.takeOver(
            (q, qd) -> new StopL(arm, q, new Joints(1e-3, 0, 2e-3, 0, 0, 1e-3), TCP, 1e-6, 1e-6));
      }
      case PAUSE -> {
        motion.resume();
        line(new MoveLimits(1, 5e-4, 0));
        motion.step();
        motion.halt(1.8e-6);
      }
    }
    if (kind == Kind.PATH_OFFSET) {
      box.offsets().path().setAlpha(1e-5);
      box.offsets().path().set(new Pose(0.02, 0.02, 0, 0.1, 0, 0.1), OffsetType.BASE);
      box.offsets().path().enable();
    }
  }

  /** So that there is something to stop. */
  private void moveALittle() throws PlanningException {
    continueWith(
        box.modes()
            .servoing()
            .speedJ(new Joints(1e-3, 0, 2e-3, 0, 0, 1e-3), 1, OptionalDouble.of(0.002)));
    motion.step();
  }

  private void start(Move move) throws PlanningException {
    MotionTicket _ = motion.start(move).orElseThrow();
  }

  private void continueWith(MotionPlan plan) throws PlanningException {
    motion.continueWith(plan);
  }

  /** Continues until the first move is handed over, so that the blend is what comes. */
  private void blend(Move first, Move second) throws PlanningException {
    MotionTicket ticket = motion.start(first).orElseThrow();
    ticket.outlook(List.of(second));
    while (!ticket.finished()) {
      motion.step();
    }
    start(second);
  }

  private void line() throws PlanningException {
    line(SLOWLY);
  }

  private void line(MoveLimits limits) throws PlanningException {
    Pose goal = beside(0.1, 0.2, 0.1);
    start(
        new Move(
            from -> Routes.line(arm, from, forward.tcpPose(from, TCP), goal, TCP), limits, 0, 0));
  }

  private Move line(Pose goal, double radiusM) {
    return new Move(
        from -> Routes.line(arm, from, forward.tcpPose(from, TCP), goal, TCP), SLOWLY, radiusM, 0);
  }

  private Move joints(Joints goal, double radiusM) {
    return new Move(
        from -> Routes.joints(arm, from, goal, forward.tcpPose(goal, TCP), TCP),
        new MoveLimits(1, 1e-4, 0),
        radiusM,
        JERK_RAMP_S);
  }

  private Move process(Pose goal, double radiusM) {
    return new Move(
        from -> Routes.line(arm, from, forward.tcpPose(from, TCP), goal, TCP),
        SLOWLY,
        radiusM,
        0,
        Move.Kind.PROCESS);
  }

  private Move circle(MoveLimits limits) {
    ArcRoute arc =
        new ArcRoute(
            arm, beside(0.05, 0.05, 0), beside(0, 0.1, 0), false, TCP, PathLimits.UNLIMITED);
    return new Move(
        from -> arc.from(from, forward.tcpPose(from, TCP)), limits, 0, 0, Move.Kind.PROCESS);
  }

  private Pose beside(double x, double y, double z) {
    return Poses.add(forward.tcpPose(READY, TCP), new Pose(x, y, z, 0, 0, 0));
  }

  /** Is pushed by turns this way and that, while a conveyor moves the path to and fro. */
  private void press(FrameKind frame) throws PlanningException {
    box.offsets()
        .conveyor()
        .trackLinear(new Pose(0, 1, 0, 0, 0, 0), 100_000, box.offsets().encoders().get(0));
    List<ForceAxis> axes = new ArrayList<>();
    for (int i = 0; i < ForceTask.AXES; i++) {
      axes.add(new ForceAxis(i == 0 || i == 2, 0, 0.1));
    }
    force.start(new ForceTask(frame, Pose.ZERO, axes), beside(0, 0, 0));
    line(new MoveLimits(1, 1e-5, 0));
  }

  private RunPlan toolpath() throws PlanningException {
    boolean remote = kind == Kind.TOOLPATH_REMOTE;
    boolean free = kind == Kind.TOOLPATH_FREE;
    Pose flange = forward.flangePose(READY);
    ToolConfiguration toolConfiguration =
        new ToolConfiguration(remote, remote ? Poses.trans(flange, TCP) : TCP);
    Toolpaths toolpaths = new Toolpaths(arm, true);
    toolpaths.initialize(toolConfiguration, free);
    toolpaths.setPcs(remote ? TCP : Poses.trans(flange, TCP));
    int lines = 100;
    for (int i = 1; i <= lines; i++) {
      double angle = 0.04 * i;
      toolpaths.addLinear(
          new Pose(0.05 * Math.cos(angle) - 0.05, 0.05 * Math.sin(angle), 0, 0, 0, 0),
          1.2,
          1e-4,
          0.001);
    }
    return toolpaths.plan(lines - 1, READY, TCP).result();
  }
}
