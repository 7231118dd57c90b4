package org.pendant.desktop.scene;

import static org.pendant.desktop.scene.SceneTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.safety.ToolDirection;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.models.arm.Joints;

/**
 * Safety sight: what is to be seen of the safety functions; immutable.
 *
 * @param planes that bound the space of the tool
 * @param directions of the tool that are allowed: what holds, and what is proposed
 * @param joints whose ranges are drawn
 * @param reach whether the outline of what the arm reaches is drawn
 * @param hitLinks links of the arm that have hit something, or that another arm has hit, as stops
 *     call them
 */
public record SafetySight(
    List<Plane> planes,
    List<Direction> directions,
    List<Range> joints,
    boolean reach,
    List<String> hitLinks) {
  /** Nothing of them. */
  public static final SafetySight NONE = new SafetySight(List.of(), List.of(), List.of(), false);

  /** What a restriction does now. */
  public enum State {
    /** It restricts the arm. */
    HOLDS,
    /** It waits for the other one of the normal and the reduced mode. */
    WAITS,
    /** It is typed in a form and not applied yet. */
    PROPOSED,
    /** It has stopped the arm. */
    TRIPPED;

    /** Whether its name must be seen, before those of places: it is what people look for now. */
    public boolean named() {
      return this == PROPOSED || this == TRIPPED;
    }
  }

  /** A safety plane, and what it does. */
  public record Plane(SafetyPlane plane, State state) {
    /** Its name, and when it holds where that is not always, as it is written beside it. */
    public String words() {
      String words =
          switch (plane.applies()) {
            case BOTH -> plane.name();
            case NORMAL -> text("planeInNormalMode", plane.name());
            case REDUCED -> text("planeInReducedMode", plane.name());
            case TRIGGERS_REDUCED -> text("planeTriggersReducedMode", plane.name());
          };
      String whole = plane.elbow() ? text("elbowToo", words) : words;
      return state == State.PROPOSED ? text("notApplied", whole) : whole;
    }
  }

  /** Where the tool may point, and what becomes of it. */
  public record Direction(ToolDirection limit, State state) {}

  /**
   * The range of a joint.
   *
   * @param joint 0 to 5, base first
   * @param minRad smallest position, rad; minus infinity for none
   * @param maxRad largest position, rad; infinity for none
   */
  public record Range(int joint, double minRad, double maxRad, State state) {
    private static final List<String> NAMES =
        List.of(
            text("base"),
            text("shoulder"),
            text("elbow"),
            text("wrist1"),
            text("wrist2"),
            text("wrist3"));

    /**
     * The joint and its range, as it is written beside it.
     *
     * @param unit of angles
     */
    public String words(DisplayUnit unit) {
      boolean degrees = unit == DisplayUnit.DEGREE;
      String words =
          Double.isInfinite(minRad) && Double.isInfinite(maxRad)
              ? text("noLimit", NAMES.get(joint))
              : text(
                  "range",
                  NAMES.get(joint),
                  angle(minRad, degrees),
                  angle(maxRad, degrees),
                  degrees ? "\u00b0" : " " + unit.symbol());
      return state == State.PROPOSED ? text("notApplied", words) : words;
    }

    private static String angle(double rad, boolean degrees) {
      if (Double.isInfinite(rad)) {
        return text("any");
      }
      return degrees
          ? String.valueOf(Math.round(Math.toDegrees(rad)))
          : String.format(Locale.ROOT, "%.2f", rad);
    }
  }

  /**
   * What people want to see.
   *
   * @param joints the range of the joint that is nearest to its limit
   */
  public record Wanted(boolean planes, boolean direction, boolean joints, boolean reach) {}

  /** Copies the lists. */
  public SafetySight {
    planes = List.copyOf(planes);
    directions = List.copyOf(directions);
    joints = List.copyOf(joints);
    hitLinks = List.copyOf(hitLinks);
  }

  /** Without a link that has hit something. */
  public SafetySight(
      List<Plane> planes, List<Direction> directions, List<Range> joints, boolean reach) {
    this(planes, directions, joints, reach, List.of());
  }

  /**
   * What is seen of a configuration. What has stopped the arm and what is proposed is seen in any
   * case.
   *
   * @param proposed what people type and have not applied yet
   * @param stop that keeps the arm at rest
   * @param reduced whether the reduced limits hold
   * @param positionRad of the joints, rad
   */
  public static SafetySight of(
      SafetyConfiguration holds,
      Optional<SafetyConfiguration> proposed,
      Optional<SafetyStop> stop,
      boolean reduced,
      Joints positionRad,
      Wanted wanted) {
    return new SafetySight(
        planes(holds, proposed, stop, reduced, wanted.planes),
        directions(holds, proposed, stop, reduced, wanted.direction),
        ranges(holds, proposed, stop, reduced, positionRad, wanted.joints),
        wanted.reach,
        stop.map(SafetyStop::hitLinks).orElse(List.of()));
  }

  /** With links that another arm has hit. */
  public SafetySight andHit(List<String> links) {
    List<String> all = new ArrayList<>(hitLinks);
    all.addAll(links);
    return new SafetySight(planes, directions, joints, reach, all);
  }

  private static List<Plane> planes(
      SafetyConfiguration holds,
      Optional<SafetyConfiguration> proposed,
      Optional<SafetyStop> stop,
      boolean reduced,
      boolean wanted) {
    Optional<String> tripped = stop.flatMap(SafetyStop::plane);
    List<Plane> planes = new ArrayList<>();
    for (SafetyPlane each : holds.planes()) {
      boolean trips = tripped.equals(Optional.of(each.name()));
      if (wanted || trips) {
        planes.add(new Plane(each, trips ? State.TRIPPED : state(each.applies(), reduced)));
      }
    }
    proposed.stream()
        .flatMap(draft -> draft.planes().stream())
        .filter(each -> !holds.planes().contains(each))
        .forEach(each -> planes.add(new Plane(each, State.PROPOSED)));
    return planes;
  }

  private static State state(Applies applies, boolean reduced) {
    return applies == Applies.TRIGGERS_REDUCED || applies.restricts(reduced)
        ? State.HOLDS
        : State.WAITS;
  }

  private static List<Direction> directions(
      SafetyConfiguration holds,
      Optional<SafetyConfiguration> proposed,
      Optional<SafetyStop> stop,
      boolean reduced,
      boolean wanted) {
    boolean trips = stop.filter(SafetyStop::aboutToolDirection).isPresent();
    List<Direction> directions = new ArrayList<>();
    holds
        .toolDirection()
        .filter(each -> wanted || trips)
        .map(each -> new Direction(each, trips ? State.TRIPPED : state(each.applies(), reduced)))
        .ifPresent(directions::add);
    proposed
        .flatMap(SafetyConfiguration::toolDirection)
        .filter(each -> !holds.toolDirection().equals(Optional.of(each)))
        .ifPresent(each -> directions.add(new Direction(each, State.PROPOSED)));
    return directions;
  }

  private static List<Range> ranges(
      SafetyConfiguration holds,
      Optional<SafetyConfiguration> proposed,
      Optional<SafetyStop> stop,
      boolean reduced,
      Joints positionRad,
      boolean wanted) {
    List<Range> ranges = new ArrayList<>();
    SafetyLimits limits = reduced ? holds.reduced() : holds.normal();
    OptionalInt tripped = stop.map(SafetyStop::jointAtItsLimit).orElse(OptionalInt.empty());
    if (tripped.isPresent()) {
      ranges.add(range(limits, tripped.getAsInt(), State.TRIPPED));
    }
    if (wanted) {
      int nearest = nearest(limits, positionRad);
      if (tripped.isEmpty() || tripped.getAsInt() != nearest) {
        ranges.add(range(limits, nearest, State.HOLDS));
      }
    }
    if (proposed.isPresent()) {
      addChanged(holds.normal(), proposed.get().normal(), ranges);
      addChanged(holds.reduced(), proposed.get().reduced(), ranges);
    }
    // Those of one joint lie on each other: where one is typed, it is the one to be seen, and once.
    Set<Integer> typed =
        ranges.stream()
            .filter(each -> each.state() == State.PROPOSED)
            .map(Range::joint)
            .collect(Collectors.toSet());
    return ranges.stream()
        .filter(each -> each.state() != State.HOLDS || !typed.contains(each.joint()))
        .distinct()
        .toList();
  }

  private static void addChanged(SafetyLimits before, SafetyLimits after, List<Range> ranges) {
    for (int i = 0; i < Joints.COUNT; i++) {
      if (before.jointMinRad().get(i) != after.jointMinRad().get(i)
          || before.jointMaxRad().get(i) != after.jointMaxRad().get(i)) {
        ranges.add(range(after, i, State.PROPOSED));
      }
    }
  }

  private static Range range(SafetyLimits limits, int joint, State state) {
    return new Range(
        joint, limits.jointMinRad().get(joint), limits.jointMaxRad().get(joint), state);
  }

  /** The joint with the least way left to its limit. */
  private static int nearest(SafetyLimits limits, Joints positionRad) {
    int nearest = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < Joints.COUNT; i++) {
      double q = positionRad.get(i);
      double left = Math.min(q - limits.jointMinRad().get(i), limits.jointMaxRad().get(i) - q);
      if (left < least) {
        least = left;
        nearest = i;
      }
    }
    return nearest;
  }
}
