package org.pendant.project.program.script;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Timing;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaypointPosition;

/** Direction writer: writes directional moves that something ends early. */
final class DirectionWriter {
  private static final String TCP_SPEED = "get_target_tcp_speed()";

  /** From a contact back to where it began. */
  private static final double RETRACTION_M_PER_S = 0.1;

  /** Farther than any arm reaches, m: for ways that something else ends. */
  private static final double ENDLESS_M = 1000;

  private final ScriptContext context;
  private final ScriptStepWriter steps;
  private final ScriptLines lines;
  private final SignalCode signals;

  DirectionWriter(ScriptContext context, ScriptStepWriter steps) {
    this.context = context;
    this.steps = steps;
    lines = context.lines();
    signals = new SignalCode(context.installation());
  }

  /**
   * What is being watched.
   *
   * @param start variable with the pose of the TCP where it began; empty for a direction
   * @param accelerationMPerS2 with which it is stopped
   */
  private record Watched(WatchedMove move, Optional<String> start, double accelerationMPerS2) {
    void stop() {
      stop(accelerationMPerS2);
    }

    void stop(double decelerationMPerS2) {
      move.stop("stopl(" + ScriptText.number(decelerationMPerS2) + ")");
    }
  }

  /**
   * A way in a direction with what ends it.
   *
   * @param move the move that it belongs to
   */
  void write(ProgramNode node, MotionStep.Direction direction, MotionStep.Move move) {
    List<ProgramNode> untils = untils(node.children());
    Optional<String> frame = frame(direction.feature());
    String vector = vector(direction);
    if (untils.isEmpty() || frame.isEmpty() || vector.isEmpty()) {
      lines.begin(node, ScriptLines.NO_BREAK);
      lines.line("# this direction needs a length and something that ends it");
      lines.end();
      return;
    }
    boolean joint = move.kind() == MoveKind.JOINT;
    double speed =
        direction
            .speedMPerS()
            .orElse(joint ? NodeFields.speed(MoveKind.LINEAR).initialValue() : move.speed());
    double acceleration =
        direction
            .accelerationMPerS2()
            .orElse(
                joint
                    ? NodeFields.acceleration(MoveKind.LINEAR).initialValue()
                    : move.acceleration());
    Optional<UntilRule.Distance> distance = distance(untils);
    lines.begin(node);
    WatchedMove watched = new WatchedMove(context, node);
    watched.startMove(
        () -> {
          lines.line(
              "local towardsPos = "
                  + context.pointTowards()
                  + "("
                  + frame.get()
                  + ", "
                  + vector
                  + ", "
                  + ScriptText.number(distance.map(UntilRule.Distance::distanceM).orElse(ENDLESS_M))
                  + ")");
          lines.line(
              "movel(towardsPos, a="
                  + ScriptText.number(acceleration)
                  + ", v="
                  + ScriptText.number(speed)
                  + distance
                      .map(UntilRule.Distance::blendRadiusM)
                      .map(MotionWriter::blend)
                      .orElse("")
                  + ")");
        });
    watch(new Watched(watched, Optional.empty(), acceleration), untils, distance);
    lines.end();
  }

  /** The axes of a direction; those of the tool are where it really is. */
  private Optional<String> frame(String feature) {
    return feature.equals(WaypointPosition.TOOL)
        ? Optional.of("get_forward_kin()")
        : steps.motion().frame(feature);
  }

  /** An expression for three numbers, or for a pose that begins with them; empty for none. */
  private static String vector(MotionStep.Direction direction) {
    String expression = ScriptText.oneLine(direction.expression().strip());
    double length = Math.hypot(Math.hypot(direction.x(), direction.y()), direction.z());
    if (expression.isEmpty() && length > 0 && Double.isFinite(length)) {
      return ScriptText.list(direction.x(), direction.y(), direction.z());
    }
    return expression;
  }

  /** Defines the function that says where a direction leads. */
  static void define(ScriptLines lines, String function) {
    lines.open("def " + function + "(feature, direction, position_distance):");
    lines.line("local posDir = [direction[0], direction[1], direction[2]]");
    lines.open("if (norm(posDir) < 1e-6):");
    lines.line("return get_target_waypoint()");
    lines.close();
    lines.line("local unit = normalize(posDir)");
    lines.line("local displacement = p" + scaled("unit", "position_distance"));
    lines.line("local inBase = pose_sub(pose_trans(feature, displacement), feature)");
    lines.line("return pose_add(get_target_waypoint(), inBase)");
    lines.close();
  }

  /**
   * The way to a waypoint that something may end early; the node is begun and ended by who calls.
   *
   * @param node the waypoint
   * @param statement what goes there, without anything else
   * @param children of the waypoint that are not suppressed
   */
  void writeWaypoint(
      ProgramNode node,
      MotionStep.Waypoint waypoint,
      MotionStep.Move move,
      String statement,
      List<ProgramNode> children) {
    double acceleration =
        move.kind() == MoveKind.JOINT
            ? NodeFields.acceleration(MoveKind.LINEAR).initialValue()
            : move.acceleration();
    if (waypoint.timing() instanceof Timing.Own own && move.kind() != MoveKind.JOINT) {
      acceleration = own.acceleration();
    }
    List<ProgramNode> untils = untils(children);
    String start = context.names().numbered("move_start");
    lines.line("global " + start + " = get_target_tcp_pose()");
    WatchedMove watched = new WatchedMove(context, node);
    watched.startMove(() -> lines.line(statement));
    watch(new Watched(watched, Optional.of(start), acceleration), untils, Optional.empty());
  }

  private static List<ProgramNode> untils(List<ProgramNode> children) {
    return children.stream()
        .filter(each -> !each.suppressed() && each.step() instanceof MotionStep.Until)
        .toList();
  }

  private static UntilRule rule(ProgramNode until) {
    return ((MotionStep.Until) until.step()).rule();
  }

  /** The shortest way after which something ends. */
  private static Optional<UntilRule.Distance> distance(List<ProgramNode> untils) {
    return untils.stream()
        .map(DirectionWriter::rule)
        .filter(UntilRule.Distance.class::isInstance)
        .map(UntilRule.Distance.class::cast)
        .min(Comparator.comparingDouble(UntilRule.Distance::distanceM));
  }

  /**
   * An expression for a direction in the base frame, of length 1, in the first three of six
   * numbers; empty if it has no length or there is no such feature.
   */
  Optional<String> vector(String feature, double x, double y, double z) {
    double length = Math.hypot(Math.hypot(x, y), z);
    if (!(length > 0 && Double.isFinite(length))) {
      return Optional.empty();
    }
    return along(feature, "p" + ScriptText.list(x / length, y / length, z / length, 0, 0, 0));
  }

  /** A direction in a feature, seen from the base frame; empty if there is no such feature. */
  private Optional<String> along(String feature, String unit) {
    return feature.equals(WaypointPosition.BASE)
        ? Optional.of(unit)
        : steps
            .motion()
            .frame(feature)
            .map(frame -> "pose_sub(pose_trans(" + frame + ", " + unit + "), " + frame + ")");
  }

  /** Six numbers, the way a distance long. */
  static String scaled(String way, String distance) {
    return "["
        + way
        + "[0] * "
        + distance
        + ", "
        + way
        + "[1] * "
        + distance
        + ", "
        + way
        + "[2] * "
        + distance
        + ", 0, 0, 0]";
  }

  private void watch(Watched watched, List<ProgramNode> untils, Optional<UntilRule.Distance> goal) {
    watched.move().watch();
    boolean ends = false;
    for (ProgramNode until : untils) {
      switch (rule(until)) {
        case UntilRule.Distance distance when goal.isPresent() -> {
          if (distance.equals(goal.get()) && !ends) {
            ends = true;
            reached(until, watched);
          }
        }
        case UntilRule.Distance distance -> stopped(until, watched, travelled(watched, distance));
        case UntilRule.Contact contact -> contact(until, watched, contact);
        case UntilRule.Expression expression ->
            stopped(until, watched, ScriptText.condition(expression.condition()));
        case UntilRule.DigitalInput input ->
            stopped(
                until,
                watched,
                signals
                    .read(input.signal())
                    .map(level -> "(" + level + " == " + ScriptText.bool(input.level()) + ")")
                    .orElse("(False)"));
      }
    }
    if (watched.start().isPresent()) {
      watched.move().when(watched.move().done());
      watched.move().leave();
    }
    watched.move().close();
  }

  private void reached(ProgramNode until, Watched watched) {
    lines.line("sleep(1.0E-10)");
    watched.move().when(watched.move().done());
    watched.move().join();
    lines.begin(until);
    then(until);
  }

  private void stopped(ProgramNode until, Watched watched, String condition) {
    watched.move().when(condition);
    watched.stop();
    lines.begin(until);
    then(until);
  }

  /** What is below an Until runs once the arm rests. */
  private void then(ProgramNode until) {
    steps.writeAll(until.children());
    lines.last("break");
    lines.end();
    lines.close();
  }

  /** Whether the tool will have come so far from the start when it is stopped now. */
  private static String travelled(Watched watched, UntilRule.Distance distance) {
    return "(point_dist("
        + watched.start().orElseThrow()
        + ", get_target_tcp_pose()) + pow(norm("
        + first(TCP_SPEED)
        + "), 2) / "
        + ScriptText.number(2 * watched.accelerationMPerS2())
        + " >= "
        + ScriptText.number(distance.distanceM())
        + ")";
  }

  private static String first(String six) {
    return "[" + six + "[0], " + six + "[1], " + six + "[2]]";
  }

  /** Back along the joint positions that the arm truly had, then the retraction further. */
  private void contact(ProgramNode until, Watched watched, UntilRule.Contact contact) {
    String deceleration = ScriptText.number(contact.stopDecelerationMPerS2());
    lines.line("local targetTcpDirection = " + TCP_SPEED);
    lines.line("local stepsToRetract = tool_contact(direction=targetTcpDirection)");
    watched.move().when("(stepsToRetract > 0)");
    watched.stop(contact.stopDecelerationMPerS2());
    lines.line("local backTrackMovement = get_actual_joint_positions_history(stepsToRetract)");
    lines.line("local contactPose = get_forward_kin(backTrackMovement)");
    lines.line("local posDir = " + first("targetTcpDirection"));
    lines.line("local retractTo = contactPose");
    lines.open("if (norm(posDir) > 1e-6):");
    lines.line("local normalizedPosDir = normalize(posDir)");
    lines.line(
        "local additionalRetraction = p"
            + scaled("normalizedPosDir", ScriptText.number(contact.retractM())));
    lines.line("retractTo = pose_sub(contactPose, additionalRetraction)");
    lines.close();
    lines.line(
        "movel(retractTo, a="
            + deceleration
            + ", v="
            + ScriptText.number(RETRACTION_M_PER_S)
            + ")");
    lines.begin(until);
    then(until);
  }
}
