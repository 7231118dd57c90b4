package org.pendant.project.program.check;

import static org.pendant.project.program.check.ProgramCheckTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Timing;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

/** Motion check: checks moves and what belongs to them. */
final class MotionCheck {
  private static final int VIA_AND_END = 2;

  private final CheckContext findings;
  private final SignalCheck signals;

  MotionCheck(CheckContext findings, SignalCheck signals) {
    this.findings = findings;
    this.signals = signals;
  }

  /**
   * Checks one node.
   *
   * @param move the closest move above it
   */
  void check(ProgramNode node, MotionStep step, Optional<MotionStep.Move> move) {
    switch (step) {
      case MotionStep.Move one -> move(node, one);
      case MotionStep.Waypoint waypoint -> waypoint(node, waypoint, move);
      case MotionStep.CircleMove circle -> circle(node, circle);
      case MotionStep.Direction direction -> direction(node, direction);
      case MotionStep.Until until -> until(node, until.rule());
      case MotionStep.Home home -> {
        findings.number(node, NodeFields.HOME_SPEED, home.speedRadPerS());
        findings.number(node, NodeFields.HOME_ACCELERATION, home.accelerationRadPerS2());
        findings.number(node, NodeFields.HOME_TIME, home.timeS());
      }
    }
  }

  private void move(ProgramNode node, MotionStep.Move move) {
    speeds(node, move.kind(), move.speed(), move.acceleration());
    findings.tool(node, "tool", move.tool());
    findings.feature(node, "feature", move.feature());
    if (move.byJoints() && move.kind() != MoveKind.JOINT) {
      findings.problem(node, "byJoints", text("jointsInMoveJOnly"));
    }
    blends(running(node));
  }

  /** Speed and acceleration of a move or a place of a pattern. */
  void speeds(ProgramNode node, MoveKind kind, double speed, double acceleration) {
    findings.number(node, NodeFields.speed(kind), speed);
    findings.number(node, NodeFields.acceleration(kind), acceleration);
  }

  private void waypoint(
      ProgramNode node, MotionStep.Waypoint waypoint, Optional<MotionStep.Move> move) {
    target(node, waypoint.target());
    MoveKind kind = move.map(MotionStep.Move::kind).orElse(MoveKind.LINEAR);
    switch (waypoint.timing()) {
      case Timing.AsMove _ -> {}
      case Timing.Own own -> {
        findings.number(node, NodeFields.waypointSpeed(kind), own.speed());
        findings.number(node, NodeFields.waypointAcceleration(kind), own.acceleration());
      }
      case Timing.Duration duration -> {
        findings.number(node, NodeFields.WAYPOINT_TIME, duration.timeS());
        if (kind == MoveKind.PROCESS) {
          findings.problem(node, "timing", text("timeInMoveP"));
        }
      }
    }
    findings.number(node, NodeFields.BLEND_RADIUS, waypoint.blendRadiusM());
  }

  private void target(ProgramNode node, WaypointTarget target) {
    switch (target) {
      case WaypointTarget.Fixed fixed -> findings.taught(node, "target", fixed.name());
      case WaypointTarget.Relative relative -> {
        findings.taught(node, "target", relative.from());
        findings.taught(node, "target", relative.to());
      }
      case WaypointTarget.Variable variable ->
          findings.expression(node, "target", text("variable"), variable.expression());
    }
  }

  private void circle(ProgramNode node, MotionStep.CircleMove circle) {
    findings.number(node, NodeFields.BLEND_RADIUS, circle.blendRadiusM());
    long waypoints =
        running(node).stream().filter(each -> each.step() instanceof MotionStep.Waypoint).count();
    if (waypoints != VIA_AND_END) {
      findings.problem(node, "", text("circleWaypoints", waypoints));
    }
  }

  private void direction(ProgramNode node, MotionStep.Direction direction) {
    findings.feature(node, "feature", direction.feature());
    if (direction.expression().isBlank()) {
      vector(node, "x", direction.x(), direction.y(), direction.z());
    } else {
      findings.expression(node, "expression", text("movedDirection"), direction.expression());
    }
    findings.number(node, NodeFields.DIRECTION_SPEED, direction.speedMPerS());
    findings.number(node, NodeFields.DIRECTION_ACCELERATION, direction.accelerationMPerS2());
    if (running(node).stream().noneMatch(each -> each.step() instanceof MotionStep.Until)) {
      findings.problem(node, "", text("directionWithoutEnd"));
    }
  }

  /** A direction that has a length. */
  void vector(ProgramNode node, String field, double x, double y, double z) {
    double length = Math.hypot(Math.hypot(x, y), z);
    if (!(length > 0 && Double.isFinite(length))) {
      findings.problem(node, field, text("directionWithoutLength"));
    }
  }

  private void until(ProgramNode node, UntilRule rule) {
    switch (rule) {
      case UntilRule.Distance distance -> {
        findings.number(node, NodeFields.UNTIL_DISTANCE, distance.distanceM());
        findings.number(node, NodeFields.UNTIL_BLEND_RADIUS, distance.blendRadiusM());
      }
      case UntilRule.Contact contact -> {
        findings.number(node, NodeFields.RETRACTION, contact.retractM());
        findings.number(node, NodeFields.CONTACT_DECELERATION, contact.stopDecelerationMPerS2());
      }
      case UntilRule.Expression expression ->
          findings.expression(node, "rule", text("condition"), expression.condition());
      case UntilRule.DigitalInput input -> signals.digital(node, "rule", input.signal());
    }
  }

  /** Each blend must fit between the waypoints before and after it. */
  private void blends(List<ProgramNode> waypoints) {
    for (int i = 0; i < waypoints.size(); i++) {
      ProgramNode node = waypoints.get(i);
      if (node.step() instanceof MotionStep.Waypoint waypoint
          && waypoint.blendRadiusM().orElse(0) > 0) {
        double radius = waypoint.blendRadiusM().getAsDouble();
        if (i > 0) {
          fits(node, radius, waypoints.get(i - 1), "blendBeyondPrevious");
        }
        if (i + 1 < waypoints.size()) {
          fits(node, radius, waypoints.get(i + 1), "blendBeyondNext");
        }
      }
    }
  }

  private void fits(ProgramNode node, double radiusM, ProgramNode other, String key) {
    Optional<WaypointPosition> here = position(node);
    Optional<WaypointPosition> there = position(other);
    if (here.isEmpty() || there.isEmpty() || !here.get().feature().equals(there.get().feature())) {
      return;
    }
    double distanceM = distance(here.get().tcp(), there.get().tcp());
    if (radiusM > distanceM) {
      findings.problem(
          node,
          "blendRadiusM",
          text(key, Math.round(1000 * radiusM), Math.round(1000 * distanceM)));
    }
  }

  private Optional<WaypointPosition> position(ProgramNode node) {
    return node.step() instanceof MotionStep.Waypoint waypoint
            && waypoint.target() instanceof WaypointTarget.Fixed fixed
        ? Optional.ofNullable(findings.tree().waypoints().get(fixed.name()))
        : Optional.empty();
  }

  private static double distance(Pose a, Pose b) {
    return Math.hypot(Math.hypot(a.x() - b.x(), a.y() - b.y()), a.z() - b.z());
  }

  /** The nodes below that are not suppressed. */
  static List<ProgramNode> running(ProgramNode node) {
    return node.children().stream().filter(each -> !each.suppressed()).toList();
  }
}
