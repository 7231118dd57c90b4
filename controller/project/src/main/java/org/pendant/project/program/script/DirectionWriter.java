package org.pendant.project.program.script;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Timing;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaypointPosition;

/** Writes ways that something ends early. */
final class DirectionWriter {
  private static final double SPEED_M_PER_S = 0.25;
  private static final double ACCELERATION_M_PER_S2 = 1.2;

  private static final String TCP_SPEED = "get_target_tcp_speed()";

  /** From a contact back to where it began. */
  private static final double RETRACTION_M_PER_S = 0.1;

  /** Below it nobody can say where the tool is going. */
  private static final String STANDING = "0.001";

  /** How long one order to go on without an end lasts, s. */
  private static final String LONG_S = "10.0";

  private final ScriptContext context;
  private final StepWriter steps;
  private final ScriptLines lines;
  private final SignalCode signals;

  DirectionWriter(ScriptContext context, StepWriter steps) {
    this.context = context;
    this.steps = steps;
    lines = context.lines();
    signals = new SignalCode(context.installation());
  }

  /**
   * What is being watched.
   *
   * @param way variable with the direction of the tool in the base frame, of length 1; empty where
   *     it is not known beforehand
   * @param accelerationMPerS2 with which it is stopped
   */
  private record Watched(
      WatchedMove move, Optional<String> way, String start, double accelerationMPerS2) {
    String stop() {
      return stop(accelerationMPerS2);
    }

    static String stop(double decelerationMPerS2) {
      return "stopl(" + ScriptText.number(decelerationMPerS2) + ")";
    }
  }

  /**
   * A way in a direction with what ends it.
   *
   * @param move the move that it belongs to
   */
  void write(ProgramNode node, MotionStep.Direction direction, MotionStep.Move move) {
    List<ProgramNode> untils = untils(node.children());
    boolean computed = !direction.expression().isBlank();
    String given = computed ? context.names().numbered("move_direction") : "";
    Optional<String> vector =
        computed
            ? along(direction.feature(), unit(given))
            : vector(direction.feature(), direction.x(), direction.y(), direction.z());
    if (untils.isEmpty() || vector.isEmpty()) {
      lines.begin(node, ScriptLines.NO_BREAK);
      lines.line("# this direction needs a length and something that ends it");
      lines.end();
      return;
    }
    boolean joint = move.kind() == MoveKind.JOINT;
    double speed = direction.speedMPerS().orElse(joint ? SPEED_M_PER_S : move.speed());
    double acceleration =
        direction.accelerationMPerS2().orElse(joint ? ACCELERATION_M_PER_S2 : move.acceleration());
    String way = context.names().numbered("move_way");
    OptionalDouble distance = distance(untils);
    lines.begin(node);
    if (computed) {
      String expression = ScriptText.oneLine(direction.expression().strip());
      lines.line("global " + given + " = " + expression);
      lines.line("global " + given + " = normalize(" + first(given) + ")");
    }
    lines.line("global " + way + " = " + vector.get());
    WatchedMove watched = new WatchedMove(context);
    watched.startMove(
        () -> {
          if (distance.isPresent()) {
            lines.line(line(way, distance.getAsDouble(), speed, acceleration));
          } else {
            endless(way, speed, acceleration);
          }
        });
    watch(new Watched(watched, Optional.of(way), "", acceleration), untils, distance);
    lines.end();
  }

  /**
   * The way to a waypoint that something may end early; the node is begun and ended by who calls.
   *
   * @param statement what goes there, without anything else
   * @param children of the waypoint that are not suppressed
   */
  void writeWaypoint(
      MotionStep.Waypoint waypoint,
      MotionStep.Move move,
      String statement,
      List<ProgramNode> children) {
    double acceleration =
        move.kind() == MoveKind.JOINT ? ACCELERATION_M_PER_S2 : move.acceleration();
    if (waypoint.timing() instanceof Timing.Own own && move.kind() != MoveKind.JOINT) {
      acceleration = own.acceleration();
    }
    List<ProgramNode> untils = untils(children);
    String start = context.names().numbered("move_start");
    lines.line("global " + start + " = get_target_tcp_pose()");
    WatchedMove watched = new WatchedMove(context);
    watched.startMove(() -> lines.line(statement));
    watch(
        new Watched(watched, Optional.empty(), start, acceleration),
        untils,
        OptionalDouble.empty());
  }

  private static List<ProgramNode> untils(List<ProgramNode> children) {
    return children.stream()
        .filter(each -> !each.suppressed() && each.step() instanceof MotionStep.Until)
        .toList();
  }

  private static UntilRule rule(ProgramNode until) {
    return ((MotionStep.Until) until.step()).rule();
  }

  /** The shortest distance after which something ends. */
  private static OptionalDouble distance(List<ProgramNode> untils) {
    return untils.stream()
        .filter(each -> rule(each) instanceof UntilRule.Distance)
        .mapToDouble(each -> ((UntilRule.Distance) rule(each)).distanceM())
        .min();
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

  /** A variable with three numbers as a pose. */
  private static String unit(String three) {
    return "p[" + three + "[0], " + three + "[1], " + three + "[2], 0, 0, 0]";
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

  private static String line(
      String way, double distanceM, double speedMPerS, double accelerationMPerS2) {
    return "movel(pose_add(get_target_tcp_pose(), p"
        + scaled(way, ScriptText.number(distanceM))
        + "), a="
        + ScriptText.number(accelerationMPerS2)
        + ", v="
        + ScriptText.number(speedMPerS)
        + ")";
  }

  /** A target far away would be out of reach from the start; a speed leads as far as it goes. */
  private void endless(String way, double speedMPerS, double accelerationMPerS2) {
    lines.open("while (True):");
    lines.line(
        "speedl("
            + scaled(way, ScriptText.number(speedMPerS))
            + ", "
            + ScriptText.number(accelerationMPerS2)
            + ", "
            + LONG_S
            + ")");
    lines.close();
  }

  private void watch(Watched watched, List<ProgramNode> untils, OptionalDouble goalM) {
    watched.move().watch();
    boolean ends = false;
    for (ProgramNode until : untils) {
      switch (rule(until)) {
        case UntilRule.Distance distance when goalM.isPresent() -> {
          if (distance.distanceM() == goalM.getAsDouble() && !ends) {
            ends = true;
            watched.move().when("(" + watched.move().done() + ")");
            lines.begin(until);
            watched.move().join();
            then(until);
          }
        }
        case UntilRule.Distance distance -> {
          watched.move().when(travelled(watched, distance.distanceM()));
          stopped(until, watched);
        }
        case UntilRule.Contact contact -> contact(until, watched, contact);
        case UntilRule.Expression expression -> {
          watched.move().when(ScriptText.condition(expression.condition()));
          stopped(until, watched);
        }
        case UntilRule.DigitalInput input -> {
          watched
              .move()
              .when(
                  signals
                      .read(input.signal())
                      .map(level -> "(" + level + " == " + ScriptText.bool(input.level()) + ")")
                      .orElse("(False)"));
          stopped(until, watched);
        }
      }
    }
    if (watched.way().isEmpty()) {
      watched.move().when("(" + watched.move().done() + ")");
      watched.move().leave();
    }
    watched.move().close();
  }

  private void stopped(ProgramNode until, Watched watched) {
    lines.begin(until);
    watched.move().stop(watched.stop());
    then(until);
  }

  /** What is below an Until runs once the arm rests. */
  private void then(ProgramNode until) {
    steps.motion().tool().forget();
    steps.writeAll(until.children());
    steps.motion().tool().forget();
    lines.end();
    lines.last("break");
    lines.close();
  }

  /** Whether the tool will have come so far from the start when it is stopped now. */
  private static String travelled(Watched watched, double distanceM) {
    return "(point_dist("
        + watched.start()
        + ", get_target_tcp_pose()) + pow(norm("
        + first(TCP_SPEED)
        + "), 2) / "
        + ScriptText.number(2 * watched.accelerationMPerS2())
        + " >= "
        + ScriptText.number(distanceM)
        + ")";
  }

  private static String first(String six) {
    return "[" + six + "[0], " + six + "[1], " + six + "[2]]";
  }

  private void contact(ProgramNode until, Watched watched, UntilRule.Contact contact) {
    String back = context.names().numbered("contact_steps");
    String joints = context.names().numbered("contact_q");
    String way = watched.way().orElseGet(() -> context.names().numbered("contact_way"));
    if (watched.way().isPresent()) {
      lines.line("global " + back + " = tool_contact(direction=" + way + ")");
    } else {
      lines.line("global " + way + " = " + TCP_SPEED);
      lines.line("global " + back + " = 0");
      lines.open("if (norm(" + first(way) + ") > " + STANDING + "):");
      lines.line(back + " = tool_contact(direction=" + way + ")");
      lines.close();
    }
    watched.move().when("(" + back + " > 0)");
    lines.begin(until);
    lines.line("global " + joints + " = get_actual_joint_positions_history(" + back + ")");
    watched.move().stop(Watched.stop(contact.stopDecelerationMPerS2()));
    String touched = "get_forward_kin(" + joints + ")";
    String place = touched;
    if (contact.retractM() != 0) {
      String away = ScriptText.number(-contact.retractM());
      String unit = way;
      if (watched.way().isEmpty()) {
        unit = context.names().numbered("contact_unit");
        lines.line("global " + unit + " = normalize(" + first(way) + ")");
      }
      place = "pose_add(" + touched + ", p" + scaled(unit, away) + ")";
    }
    lines.line(
        "movel("
            + place
            + ", a="
            + ScriptText.number(contact.stopDecelerationMPerS2())
            + ", v="
            + ScriptText.number(RETRACTION_M_PER_S)
            + ")");
    then(until);
  }
}
