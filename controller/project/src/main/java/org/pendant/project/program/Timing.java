package org.pendant.project.program;

/** Timing: how fast the arm moves to a waypoint. */
public sealed interface Timing {

  /** As the move says. */
  record AsMove() implements Timing {}

  /** With its own speed and acceleration, in the units of the move. */
  record Own(double speed, double acceleration) implements Timing {}

  /** In a given time, s. */
  record Duration(double timeS) implements Timing {}
}
