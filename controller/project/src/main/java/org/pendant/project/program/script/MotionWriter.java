package org.pendant.project.program.script;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

/** Motion writer: writes moves and the places that they lead to. */
final class MotionWriter {
  private static final String ACTIVE_TOOL = "get_tcp_offset()";

  private final ScriptContext context;
  private final ScriptStepWriter steps;
  private final ScriptLines lines;
  private final ActiveTool tool;
  private final DirectionWriter directions;
  private Optional<MotionStep.Move> move = Optional.empty();

  MotionWriter(ScriptContext context, ScriptStepWriter steps) {
    this.context = context;
    this.steps = steps;
    lines = context.lines();
    tool = new ActiveTool(context);
    directions = new DirectionWriter(context, steps);
  }

  /** Which TCP is active. */
  ActiveTool tool() {
    return tool;
  }

  /** Ways that something ends early. */
  DirectionWriter directions() {
    return directions;
  }

  /** A node with all below it. */
  void write(ProgramNode node, MotionStep step) {
    switch (step) {
      case MotionStep.Move each -> writeMove(node, each);
      case MotionStep.Waypoint each -> writeWaypoint(node, each);
      case MotionStep.CircleMove each -> writeCircle(node, each);
      case MotionStep.Direction each -> writeDirection(node, each);
      case MotionStep.Until _ -> remark(node, "an Until belongs to a direction or waypoint");
      case MotionStep.Home each -> writeHome(node, each);
    }
  }

  private void writeMove(ProgramNode node, MotionStep.Move step) {
    lines.begin(node);
    Optional<MotionStep.Move> outer = move;
    move = Optional.of(step);
    steps.writeAll(node.children());
    move = outer;
    lines.end();
  }

  private void writeWaypoint(ProgramNode node, MotionStep.Waypoint waypoint) {
    Optional<String> statement = move.flatMap(each -> statement(each, waypoint));
    if (statement.isEmpty()) {
      remark(node, "this waypoint is not complete");
      return;
    }
    lines.begin(node, ScriptLines.BREAK_AFTER);
    useTool();
    List<ProgramNode> untils = node.children().stream().filter(each -> !each.suppressed()).toList();
    if (untils.isEmpty()) {
      lines.line(statement.get());
    } else {
      directions.writeWaypoint(node, waypoint, move.get(), statement.get(), untils);
    }
    lines.end();
  }

  /** Before each way of a move that has a TCP of its own, also where that is active already. */
  private void useTool() {
    move.map(MotionStep.Move::tool)
        .filter(each -> !(each instanceof ToolChoice.Flange))
        .ifPresent(tool::use);
  }

  private Optional<String> statement(MotionStep.Move in, MotionStep.Waypoint waypoint) {
    return goal(in, waypoint.target()).map(goal -> statement(in, waypoint, goal));
  }

  private static String statement(MotionStep.Move in, MotionStep.Waypoint waypoint, Goal goal) {
    double speed = in.speed();
    double acceleration = in.acceleration();
    OptionalDouble timeS = OptionalDouble.empty();
    switch (waypoint.timing()) {
      case Timing.AsMove _ -> {}
      case Timing.Own own -> {
        speed = own.speed();
        acceleration = own.acceleration();
      }
      case Timing.Duration duration -> timeS = OptionalDouble.of(duration.timeS());
    }
    return statement(in.kind(), goal, speed, acceleration, timeS, waypoint.blendRadiusM());
  }

  /**
   * The statement that goes somewhere.
   *
   * @param speed of the leading joint or of the tool, as {@link MotionStep.Move#speed}
   * @param timeS how long it takes, instead; has no meaning for {@link MoveKind#PROCESS}
   */
  static String statement(
      MoveKind kind,
      Goal goal,
      double speed,
      double acceleration,
      OptionalDouble timeS,
      OptionalDouble blendRadiusM) {
    StringBuilder text = new StringBuilder();
    switch (kind) {
      case JOINT -> text.append("movej(").append(goal.forJoints());
      case LINEAR -> text.append("movel(").append(goal.place());
      case PROCESS -> text.append("movep(").append(goal.place());
    }
    if (timeS.isPresent() && kind != MoveKind.PROCESS) {
      text.append(", t=").append(ScriptText.number(timeS.getAsDouble()));
    } else {
      text.append(", a=").append(ScriptText.number(acceleration));
      text.append(", v=").append(ScriptText.number(speed));
    }
    return text.append(kind == MoveKind.PROCESS ? radius(blendRadiusM) : blend(blendRadiusM))
        .append(')')
        .toString();
  }

  /** A corner of another move; nothing for a stop. */
  static String blend(OptionalDouble radiusM) {
    return radiusM.isPresent() && radiusM.getAsDouble() > 0
        ? ", r=" + ScriptText.number(radiusM.getAsDouble())
        : "";
  }

  /** Process moves and circles always say their radius. */
  private static String radius(OptionalDouble radiusM) {
    return ", r=" + ScriptText.number(radiusM.orElse(0));
  }

  /**
   * Where to go.
   *
   * @param place an expression for a pose of the TCP in the base frame, or for joint positions
   * @param joints an expression for joint positions near to which those of the pose are; empty for
   *     those of the arm, and where {@code place} is joint positions
   */
  record Goal(String place, Optional<String> joints) {
    private String forJoints() {
      return joints.map(near -> "get_inverse_kin(" + place + ", qnear=" + near + ")").orElse(place);
    }
  }

  /** Where a target is; empty if it is not complete. */
  private Optional<Goal> goal(MotionStep.Move in, WaypointTarget target) {
    boolean byJoints = in.byJoints() && in.kind() == MoveKind.JOINT;
    return switch (target) {
      case WaypointTarget.Fixed fixed -> fixed(fixed.name(), in.tool(), byJoints);
      case WaypointTarget.Relative relative ->
          context.isTaught(relative.from()) && context.isTaught(relative.to())
              ? Optional.of(relative(relative, byJoints))
              : Optional.empty();
      case WaypointTarget.Variable variable ->
          variable.expression().isBlank()
              ? Optional.empty()
              : Optional.of(new Goal(variable(in, variable.expression()), Optional.empty()));
    };
  }

  private Optional<Goal> fixed(String name, ToolChoice choice, boolean byJoints) {
    if (!context.isTaught(name)) {
      return Optional.empty();
    }
    String joints = context.names().joints(name);
    return Optional.of(
        byJoints
            ? new Goal(joints, Optional.empty())
            : new Goal(pose(name, choice), Optional.of(joints)));
  }

  private Goal relative(WaypointTarget.Relative relative, boolean byJoints) {
    ScriptNames names = context.names();
    String place =
        byJoints
            ? "get_target_joint_positions() + "
                + names.joints(relative.to())
                + " - "
                + names.joints(relative.from())
            : "pose_add(get_target_tcp_pose(), pose_sub("
                + pose(relative.to())
                + ", "
                + pose(relative.from())
                + "))";
    return new Goal(place, Optional.empty());
  }

  /** A pose in a feature, by what the expression says it is; joint positions stay as they are. */
  private String variable(MotionStep.Move in, String expression) {
    String place = ScriptText.oneLine(expression.strip());
    boolean joints = place.startsWith("[") || place.endsWith("_q");
    if (joints) {
      return place;
    }
    boolean inBase = in.feature().equals(WaypointPosition.BASE) || frame(in.feature()).isEmpty();
    String pose = inBase ? place : trans(frame(in.feature()).get(), place);
    return in.tool() instanceof ToolChoice.Flange ? trans(pose, ACTIVE_TOOL) : pose;
  }

  private static String trans(String from, String to) {
    return "pose_trans(" + from + ", " + to + ")";
  }

  /**
   * An expression for the pose of a feature in the base frame, now: {@code Base}, {@code Tool} or
   * one of the installation; empty if there is no such feature.
   */
  Optional<String> frame(String feature) {
    return switch (feature) {
      case WaypointPosition.BASE -> Optional.of(ScriptText.pose(Pose.ZERO));
      case WaypointPosition.TOOL -> Optional.of("get_target_tcp_pose()");
      default ->
          context
              .installation()
              .feature(feature)
              .filter(each -> FeaturePoses.pose(each).isPresent())
              .map(each -> context.names().variable(each.name()));
    };
  }

  /** An expression for the pose of a taught place in the base frame, of the TCP that is active. */
  String pose(String waypoint) {
    Optional<WaypointPosition> taught = context.taught(waypoint);
    return taught
        .flatMap(each -> context.installation().feature(each.feature()))
        .filter(Feature::variable)
        .flatMap(each -> moved(each, context.names().pose(waypoint)))
        .orElseGet(() -> context.names().pose(waypoint));
  }

  /** A place in the base frame as it was taught, gone along with its feature. */
  private Optional<String> moved(Feature feature, String place) {
    return frame(feature.name())
        .flatMap(
            now ->
                FeaturePoses.pose(feature)
                    .map(then -> trans(now, trans(ScriptText.pose(Poses.inverse(then)), place))));
  }

  /**
   * As {@link #pose(String)}; if the flange is chosen, where the active TCP is once the flange is
   * where it was taught. Which TCP is active stays as it is.
   */
  private String pose(String waypoint, ToolChoice choice) {
    if (!(choice instanceof ToolChoice.Flange)) {
      return pose(waypoint);
    }
    Pose taughtTool =
        context.taught(waypoint).map(WaypointPosition::toolInFlange).orElse(Pose.ZERO);
    String toTool =
        taughtTool.equals(Pose.ZERO)
            ? ACTIVE_TOOL
            : trans(ScriptText.pose(Poses.inverse(taughtTool)), ACTIVE_TOOL);
    return trans(pose(waypoint), toTool);
  }

  private void writeCircle(ProgramNode node, MotionStep.CircleMove circle) {
    List<ProgramNode> ends = node.children().stream().filter(each -> !each.suppressed()).toList();
    List<Goal> goals =
        ends.stream()
            .filter(each -> each.step() instanceof MotionStep.Waypoint)
            .flatMap(each -> circleGoal((MotionStep.Waypoint) each.step()).stream())
            .toList();
    if (move.isEmpty() || ends.size() != 2 || goals.size() != 2) {
      remark(node, "this circle needs two complete waypoints in a move");
      return;
    }
    lines.begin(node);
    lines.begin(ends.getFirst(), ScriptLines.NO_BREAK);
    lines.begin(ends.getLast(), ScriptLines.BREAK_AFTER);
    useTool();
    lines.line(
        "movec("
            + goals.getFirst().place()
            + ", "
            + goals.getLast().place()
            + ", a="
            + ScriptText.number(move.get().acceleration())
            + ", v="
            + ScriptText.number(move.get().speed())
            + radius(circle.blendRadiusM())
            + (circle.fixedOrientation() ? ", mode=1" : "")
            + ")");
    lines.end();
    lines.end();
    lines.end();
  }

  private Optional<Goal> circleGoal(MotionStep.Waypoint waypoint) {
    return move.flatMap(each -> goal(each, waypoint.target()));
  }

  private void writeDirection(ProgramNode node, MotionStep.Direction direction) {
    if (move.isEmpty()) {
      remark(node, "a direction belongs to a move");
    } else {
      directions.write(node, direction, move.get());
    }
  }

  private void writeHome(ProgramNode node, MotionStep.Home home) {
    lines.begin(node, ScriptLines.BREAK_AFTER);
    Goal goal = new Goal(ScriptText.joints(context.installation().homeRad()), Optional.empty());
    lines.line(
        statement(
            MoveKind.JOINT,
            goal,
            home.speedRadPerS(),
            home.accelerationRadPerS2(),
            home.timeS(),
            OptionalDouble.empty()));
    lines.end();
  }

  private void remark(ProgramNode node, String text) {
    lines.begin(node, ScriptLines.NO_BREAK);
    lines.line("# " + text);
    lines.end();
  }
}
