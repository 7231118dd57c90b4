package org.pendant.desktop.session;

import org.pendant.script.vm.ProgramState;

/**
 * Run time: how long a program has run in robot time, apart from its pauses. Times are in seconds
 * since the controller was switched on.
 *
 * @param beganS when the program was started; NaN before the first
 * @param pausedS how long the pauses before {@code pauseBeganS} took together
 * @param pauseBeganS when the present pause began, NaN for none
 * @param endedS when the program ended, NaN while it has not
 */
public record RunTime(double beganS, double pausedS, double pauseBeganS, double endedS) {
  /** No program has run, or nobody knows since when it runs. */
  public static final RunTime NONE = new RunTime(Double.NaN, 0, Double.NaN, Double.NaN);

  /** A program starts at {@code timeS}. */
  public static RunTime began(double timeS) {
    return new RunTime(timeS, 0, Double.NaN, Double.NaN);
  }

  /** The same, paused at {@code timeS}. */
  public RunTime paused(double timeS) {
    return new RunTime(beganS, pausedS, timeS, Double.NaN);
  }

  /** The same, resumed at {@code timeS}. */
  public RunTime resumed(double timeS) {
    return new RunTime(beganS, pausedS(timeS), Double.NaN, Double.NaN);
  }

  private RunTime ended(double timeS) {
    return new RunTime(beganS, pausedS(timeS), Double.NaN, timeS);
  }

  /** The same, whose program is in another state from {@code timeS} on. */
  public RunTime changed(ProgramState now, double timeS) {
    return switch (now) {
      case RUNNING -> resumed(timeS);
      case PAUSED -> paused(timeS);
      case STOPPED -> ended(timeS);
    };
  }

  /** Whether there is a run to tell of. */
  public boolean known() {
    return !Double.isNaN(beganS);
  }

  /** How long the program has run until {@code timeS}, s. */
  public double ranS(double timeS) {
    double untilS = Double.isNaN(endedS) ? timeS : endedS;
    return known() ? untilS - beganS - pausedS(untilS) : 0;
  }

  /** How long it was paused until {@code timeS}, s. */
  public double pausedS(double timeS) {
    return Double.isNaN(pauseBeganS) ? pausedS : pausedS + timeS - pauseBeganS;
  }
}
