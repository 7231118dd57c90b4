package org.pendant.controller.safety;

import org.pendant.controller.command.Command;

/** Command to the safety system: power, brakes, stops, modes and safety inputs. */
public sealed interface SafetyCommand extends Command {

  /** Powers the arm on; it rests on its brakes then. */
  record PowerOn() implements SafetyCommand {}

  /** Powers the arm off; a program ends. */
  record PowerOff() implements SafetyCommand {}

  /** Releases the brakes of a powered arm; programs may start then. */
  record ReleaseBrakes() implements SafetyCommand {}

  /**
   * Ends a protective stop; the program stays paused.
   *
   * @param early also within 5 s of the stop, the time that people have to look at what has
   *     happened
   */
  record UnlockProtectiveStop(boolean early) implements SafetyCommand {}

  /**
   * Starts the safety functions again after a violation or a fault; the arm is powered off then.
   */
  record RestartSafety() implements SafetyCommand {}

  /** Lets a powered arm be pushed about by hand. */
  record StartBackdrive() implements SafetyCommand {}

  /** Locks the brakes again after {@link StartBackdrive}. */
  record EndBackdrive() implements SafetyCommand {}

  /**
   * Chooses manual mode or leaves it: the safeguard stop of automatic mode does not count in it.
   */
  record SetManualMode(boolean manual) implements SafetyCommand {}

  /** Demands a safety function, or no longer does. */
  record SetSafetyInput(SafetyInput input, boolean active) implements SafetyCommand {}
}
