package org.pendant.controller.io;

/** Run state action: what an output does when a program starts or ends (manual 19.6 to 19.10). */
public enum RunStateAction {
  /** It stays as it is. */
  PRESERVE,
  /** It is low while no program runs. */
  LOW_WHEN_NOT_RUNNING,
  /** It is high while no program runs. */
  HIGH_WHEN_NOT_RUNNING,
  /** It is high while a program runs, and low otherwise. */
  HIGH_WHEN_RUNNING,
  /** It goes low when a program ends unexpectedly. */
  LOW_ON_UNSCHEDULED_STOP,
  /** It goes high when a program starts, and low when it ends unexpectedly. */
  HIGH_FROM_START_LOW_ON_UNSCHEDULED_STOP,
  /** It is high while the arm has power, and low otherwise. */
  HIGH_WITH_POWER,
  /** It is low while the arm has power, and high otherwise. */
  LOW_WITH_POWER;

  /** The action that scripts call by {@code number}, 0 to 7. */
  public static RunStateAction of(int number) {
    return values()[number];
  }
}
