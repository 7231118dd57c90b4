package org.pendant.controller.command;

/**
 * Refusal of what a client has asked for: nothing has been changed.
 *
 * @param code what kind of reason it is, for programs
 * @param text what, the value, what was expected, for people
 */
public record Refusal(Code code, String text) {

  /** Kind of reason. */
  public enum Code {
    /** The arm moves, and must be at rest. */
    ARM_MOVES,
    /** The arm has no power or is on its brakes, or its power is in the wrong mode. */
    ARM_POWER,
    /** The arm cannot go there: the end of a range, a singularity, a plane, no solution. */
    ARM_RANGE,
    /** A debugger has paused the program in the middle of a frame. */
    DEBUGGER,
    /** Another client has taken it. */
    IN_USE,
    /** A value is out of its range or of another form. */
    INVALID,
    /** As many as there may be are there. */
    LIMIT,
    /** A program runs or is paused where none may, or none does where one must. */
    PROGRAM,
    /** A safety function forbids it, or there is none of its stops to end. */
    SAFETY,
    /** The controller has been switched off. */
    SWITCHED_OFF,
    /** There is nothing of this name or number. */
    UNKNOWN
  }

  /** The text, as a message ends with it. */
  @Override
  public String toString() {
    return text;
  }
}
