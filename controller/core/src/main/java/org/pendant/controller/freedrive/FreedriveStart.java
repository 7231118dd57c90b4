package org.pendant.controller.freedrive;

/** What came of asking for freedrive. */
public sealed interface FreedriveStart {

  /** The arm is guided from this frame on. */
  record Started() implements FreedriveStart {}

  /**
   * It is not.
   *
   * @param reason why
   */
  record Refused(String reason) implements FreedriveStart {}

  /**
   * It is not: the declared payload is not what the flange carries.
   *
   * @param errorN by how much, N
   * @param toleranceN how much is allowed, N
   */
  record WrongPayload(double errorN, double toleranceN) implements FreedriveStart {}
}
