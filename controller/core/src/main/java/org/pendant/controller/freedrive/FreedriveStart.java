package org.pendant.controller.freedrive;

import org.pendant.controller.command.Refusal;

/** Outcome of asking for freedrive. */
public sealed interface FreedriveStart {

  /** The arm is guided from this frame on. */
  record Started() implements FreedriveStart {}

  /** It is not. */
  record Refused(Refusal refusal) implements FreedriveStart {}

  /**
   * It is not: the declared payload is not what the flange carries.
   *
   * @param errorN by how much, N
   * @param toleranceN how much is allowed, N
   */
  record WrongPayload(double errorN, double toleranceN) implements FreedriveStart {}
}
