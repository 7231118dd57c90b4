package org.pendant.controller;

import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.debug.Debugger;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.jog.Jogging;
import org.pendant.controller.machine.Program;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.world.Vector3;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;

/** What somebody outside asks of a controller; carried out at the begin of the next frame. */
public sealed interface Command {

  /** Starts a program; refused while another one runs or is paused. */
  record StartProgram(Program program) implements Command {}

  /** Ends the program; the arm comes to rest on its path. */
  record StopProgram() implements Command {}

  /** Holds script time; the arm comes to rest on its path. */
  record PauseProgram() implements Command {}

  /** Goes on after a pause; a popup that caused it closes. */
  record ResumeProgram() implements Command {}

  /** Runs a secondary program beside the primary one, to its end (manual 12). */
  record RunSecondary(Program program) implements Command {}

  /**
   * Sets a digital input.
   *
   * @param name such as {@code digital_in[0]}, {@code configurable_in[3]} or {@code tool_in[1]}
   */
  record SetInput(String name, boolean level) implements Command {}

  /**
   * Moves the speed slider.
   *
   * @param fraction 0 to 1
   */
  record SetSpeedFraction(double fraction) implements Command {}

  /** Closes a popup; a program that it paused goes on. */
  record AnswerPopup(long number) implements Command {}

  /**
   * Hands a line of statements to interpreter mode (manual 13).
   *
   * @param line bytes, one {@code char} a byte, without the line end
   */
  record Interpret(String line) implements Command {}

  /** Drops the interpreted lines that have not begun (manual 13.6). */
  record SkipInterpreted() implements Command {}

  /** Ends the move that the main thread waits for early (manual 13.5). */
  record AbortMove() implements Command {}

  /** Powers the arm on; it rests on its brakes then. */
  record PowerOn() implements Command {}

  /** Powers the arm off; a program ends. */
  record PowerOff() implements Command {}

  /** Releases the brakes of a powered arm; programs may start then. */
  record ReleaseBrakes() implements Command {}

  /** Ends a protective stop; the program stays paused. */
  record UnlockProtectiveStop() implements Command {}

  /**
   * Starts the safety functions again after a violation or a fault; the arm is powered off then.
   */
  record RestartSafety() implements Command {}

  /** Lets a powered arm be pushed about by hand. */
  record StartBackdrive() implements Command {}

  /** Locks the brakes again after {@link StartBackdrive}. */
  record EndBackdrive() implements Command {}

  /** Demands a safety function, or no longer does. */
  record SetSafetyInput(SafetyInput input, boolean active) implements Command {}

  /**
   * Pushes the tool until told otherwise.
   *
   * @param wrenchAtTcpInBase force and torque at the TCP, along the axes of the base
   */
  record PushTool(Wrench wrenchAtTcpInBase) implements Command {}

  /**
   * Hangs something on the flange, whatever programs declare.
   *
   * @param load what it is; empty for what programs declare
   */
  record AttachLoad(Optional<Payload> load) implements Command {}

  /**
   * Moves the arm by hand as long as this is repeated: at the latest every {@link
   * Jogging#DEAD_MAN_S} of robot time, or the arm comes to rest on its path. Refused while a
   * program runs or is paused, and while the arm is stopped or off; the reply to a repetition tells
   * why the arm goes no further.
   *
   * @param speedFraction above 0 and at most 1: of 0.6 rad/s for the fastest joint, or of 0.25 m/s
   *     and 1 rad/s for the tool
   */
  record Jog(JogMove move, double speedFraction) implements Command {}

  /**
   * Asks something of the debugger, in the frame loop: sets breakpoints, steps, looks at variables
   * and changes them. Refused with the message when the request throws an {@link
   * IllegalArgumentException}; what it finds out it hands over itself, for instance through a
   * future.
   */
  record Debug(Consumer<Debugger> request) implements Command {}

  /** Ends {@link Jog}: the arm comes to rest on its path. */
  record StopJog() implements Command {}

  /** Changes the active TCP; refused while the arm moves or a program runs or is paused. */
  record SetTool(ToolCentre tool) implements Command {}

  /**
   * Declares the payload, a point mass; refused while the arm moves or a program runs or is paused.
   * The force sensor is zeroed.
   *
   * @param massKg 0 to four times what the arm is made for, kg
   * @param cogInFlangeM its centre of gravity in the flange frame, m
   */
  record DeclarePayload(double massKg, Vector3 cogInFlangeM) implements Command {}
}
