package org.pendant.controller.installation;

/**
 * Start-up: what happens by itself when the robot is switched on.
 *
 * @param program that is loaded, relative to the programs folder; empty for none
 * @param startInput an input such as {@code digital_in[0]} whose edge starts the program; empty for
 *     none
 * @param startOnHigh whether the rising edge starts it, otherwise the falling one
 * @param powerInput an input whose edge switches the arm on and releases its brakes; empty for none
 * @param powerOnHigh whether the rising edge does it
 */
public record StartUp(
    String program,
    String startInput,
    boolean startOnHigh,
    String powerInput,
    boolean powerOnHigh) {
  /** Nothing does. */
  public static final StartUp NOTHING = new StartUp("", "", true, "", true);
}
