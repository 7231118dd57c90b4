package org.pendant.project.program;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** First waypoint: where a program moves the arm first. */
public final class FirstWaypoint {
  private final ProgramTree tree;
  private final Set<String> called = new HashSet<>();

  private FirstWaypoint(ProgramTree tree) {
    this.tree = tree;
  }

  /**
   * The place of the first waypoint that would be gone to if every branch was entered; empty if
   * there is none, or it was not taught, or something comes first that goes elsewhere.
   */
  public static Optional<Target> of(ProgramTree tree) {
    FirstWaypoint search = new FirstWaypoint(tree);
    List<ProgramNode> order =
        Stream.concat(
                tree.sections().stream().filter(each -> each.step() instanceof Section.BeforeStart),
                tree.sections().stream().filter(each -> each.step() instanceof Section.MainProgram))
            .toList();
    return search.among(order).flatMap(found -> found.place);
  }

  /**
   * A place to go to.
   *
   * @param name of the waypoint
   * @param position that was taught
   */
  public record Target(String name, WaypointPosition position) {}

  /** The search has come to a move; without a place it goes somewhere that was not taught. */
  private record Found(Optional<Target> place) {}

  private Optional<Found> among(List<ProgramNode> nodes) {
    for (ProgramNode each : nodes) {
      Optional<Found> found = each.suppressed() ? Optional.empty() : in(each);
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  private Optional<Found> in(ProgramNode node) {
    return switch (node.step()) {
      case MotionStep.Waypoint waypoint -> Optional.of(new Found(place(waypoint)));
      case MotionStep.Direction direction -> Optional.of(new Found(Optional.empty()));
      case MotionStep.Home home -> Optional.of(new Found(Optional.empty()));
      case TemplateStep.Palletizing palletizing -> Optional.of(new Found(Optional.empty()));
      case TemplateStep.Seek seek -> Optional.of(new Found(Optional.empty()));
      case ActionStep.Call call -> call(call.subProgram());
      default -> among(node.children());
    };
  }

  private Optional<Target> place(MotionStep.Waypoint waypoint) {
    return waypoint.target() instanceof WaypointTarget.Fixed fixed
        ? Optional.ofNullable(tree.waypoints().get(fixed.name()))
            .map(position -> new Target(fixed.name(), position))
        : Optional.empty();
  }

  private Optional<Found> call(String name) {
    if (!called.add(name)) {
      return Optional.empty();
    }
    return tree.sections().stream()
        .filter(each -> each.step() instanceof Section.SubProgram sub && sub.name().equals(name))
        .findFirst()
        .flatMap(each -> among(each.children()));
  }
}
