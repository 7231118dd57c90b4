package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.models.arm.ArmDescription;

/**
 * Safety configuration: limits and planes of one robot; {@link SafetyConfigurationReader} reads
 * them from a file.
 *
 * @param normal limits that hold as a rule
 * @param reduced limits that hold in the reduced mode; nothing wider than {@code normal}
 * @param planes at most {@value #MAX_PLANES}, each with its own name
 * @param toolDirection how far the tool may be tilted, if that is restricted
 */
public record SafetyConfiguration(
    SafetyLimits normal,
    SafetyLimits reduced,
    List<SafetyPlane> planes,
    Optional<ToolDirection> toolDirection) {
  /** Planes at most, as on the robot. */
  public static final int MAX_PLANES = 8;

  /**
   * Copies the list and checks.
   *
   * @throws IllegalArgumentException if a reduced limit is wider than the normal one, there are too
   *     many planes, or two have one name
   */
  public SafetyConfiguration {
    planes = List.copyOf(planes);
    reduced.requireWithin(normal);
    if (planes.size() > MAX_PLANES) {
      throw new IllegalArgumentException(text("tooManyPlanes", planes.size(), MAX_PLANES));
    }
    Set<String> names = new HashSet<>();
    for (SafetyPlane plane : planes) {
      if (!names.add(plane.name())) {
        throw new IllegalArgumentException(text("planeNameTwice", plane.name()));
      }
    }
  }

  /**
   * What holds when nothing is configured: no planes, a tool that may point anywhere, and limits
   * that let the arm do all that its data sheet says. docs/safety.md has the figures; they are not
   * published ones.
   */
  public static SafetyConfiguration standard(ArmDescription arm) {
    SafetyLimits normal = StandardLimits.normal(arm);
    return new SafetyConfiguration(
        normal, StandardLimits.reduced(normal), List.of(), Optional.empty());
  }

  /** The same limits with these planes. */
  public SafetyConfiguration withPlanes(SafetyPlane... others) {
    return new SafetyConfiguration(normal, reduced, List.of(others), toolDirection);
  }

  /** The same limits with this restriction of the tool. */
  public SafetyConfiguration withToolDirection(ToolDirection direction) {
    return new SafetyConfiguration(normal, reduced, planes, Optional.of(direction));
  }

  /** The same planes with other limits. */
  public SafetyConfiguration withLimits(SafetyLimits normalSet, SafetyLimits reducedSet) {
    return new SafetyConfiguration(normalSet, reducedSet, planes, toolDirection);
  }
}
