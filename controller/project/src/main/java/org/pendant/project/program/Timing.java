package org.pendant.project.program;

/** How fast a waypoint is gone to. */
public sealed interface Timing {

  /** As the move says. */
  record AsMove() implements Timing {}

  /** With its own speed and acceleration, in the units of the move. */
  record Own(double speed, double acceleration) implements Timing {}

  /** In a given time, s. */
  record Duration(double timeS) implements Timing {}
}
