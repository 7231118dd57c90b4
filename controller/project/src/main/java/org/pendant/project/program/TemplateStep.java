package org.pendant.project.program;

import java.util.List;
import java.util.OptionalDouble;

/**
 * Template node: a task that is set up by filling in a form, with children for what the task does
 * on its way.
 */
public sealed interface TemplateStep extends Step {

  /**
   * Runs its children at one place of a pattern after another, one place each time when the node is
   * reached. The children are {@link PatternPoint} and any other nodes, and {@link Part} for what
   * happens before the first and after the last place.
   *
   * @param name also of the variable that counts, {@code <name>_count}
   * @param remember whether the count is kept when the program ends
   */
  record Palletizing(String name, Pattern pattern, String feature, boolean remember)
      implements TemplateStep {}

  /**
   * Goes to a place of the pattern, or near it.
   *
   * @param waypoint where it was taught: for {@link PatternRole#POINT} the reference, for the
   *     others relative to that reference
   */
  record PatternPoint(
      PatternRole role,
      String waypoint,
      MoveKind kind,
      double speed,
      double acceleration,
      OptionalDouble blendRadiusM)
      implements TemplateStep {}

  /** What a {@link PatternPoint} is. */
  enum PatternRole {
    APPROACH,
    POINT,
    EXIT
  }

  /** A part of a template that runs at a certain time. */
  record Part(PartKind kind) implements TemplateStep {}

  /** When a {@link Part} runs. */
  enum PartKind {
    /** Before the first item. */
    BEFORE_START,
    /** After the last item. */
    AFTER_END,
    /** Each time, at the item that was found or the place of the pattern. */
    SEQUENCE
  }

  /**
   * Searches along a line for the next item of a stack, and runs its {@link PartKind#SEQUENCE}
   * there.
   *
   * @param destack whether items are taken from the stack, otherwise put on it
   * @param name also of the variable that counts, {@code <name>_count}
   * @param start name of the waypoint where the search begins
   * @param direction of the search in the feature; only its direction counts
   * @param limitM how far it goes at most
   * @param itemHeightM thickness of an item
   * @param found an expression for true when the next item has been found
   */
  record Seek(
      boolean destack,
      String name,
      String start,
      String feature,
      List<Double> direction,
      double limitM,
      double itemHeightM,
      String found,
      double speedMPerS,
      double accelerationMPerS2)
      implements TemplateStep {
    public Seek {
      direction = List.copyOf(direction);
    }
  }

  /**
   * Runs its children in force mode (manual 15.6).
   *
   * @param feature whose axes are meant
   * @param compliant six flags: x, y, z, and about them
   * @param wrench wanted along and about compliant axes, N and Nm
   * @param limits speed along and about compliant axes (m/s, rad/s), deviation of the others (m,
   *     rad)
   */
  record Force(
      ForceKind kind,
      String feature,
      List<Boolean> compliant,
      List<Double> wrench,
      List<Double> limits)
      implements TemplateStep {
    public Force {
      compliant = List.copyOf(compliant);
      wrench = List.copyOf(wrench);
      limits = List.copyOf(limits);
    }
  }

  /** How the frame of a {@link Force} is found. */
  enum ForceKind {
    /** The feature's z axis alone is compliant. */
    SIMPLE,
    /** The feature as it is. */
    FRAME,
    /** Turned so that y points from the TCP to the feature's origin. */
    POINT,
    /** Turned so that x points along the motion of the TCP. */
    MOTION
  }

  /**
   * Follows a screw while its children run or until it is done (manual 15.42).
   *
   * @param tool which TCP is the bit, its z axis along the screw
   * @param byForce whether {@code value} is a force in N, otherwise a speed in m/s
   * @param start an expression output that switches the driver on, such as {@code digital_out[0]};
   *     empty for none
   * @param until ends it successfully
   * @param timeoutS ends it with an error; 0 for never
   */
  record Screwdriving(
      ToolChoice tool,
      boolean byForce,
      double value,
      boolean loosen,
      String start,
      String until,
      double timeoutS)
      implements TemplateStep {}

  /**
   * Runs its children while the arm goes along with a conveyor.
   *
   * @param conveyor 1 or 2, as the installation has set it up
   */
  record ConveyorTracking(int conveyor) implements TemplateStep {}
}
