package org.pendant.controller;

import java.util.Optional;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.command.Command;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.jog.Jogging;
import org.pendant.controller.world.Vector3;

/** Command of an operator who moves or sets up the arm by hand. */
public sealed interface ManualCommand extends Command {

  /**
   * Moves the arm by hand as long as this is repeated: at the latest every {@link
   * Jogging#DEAD_MAN_S} of robot time, or the arm comes to rest on its path. Refused while a
   * program runs or is paused, and while the arm is stopped or off; the reply to a repetition tells
   * why the arm goes no further.
   *
   * @param speedFraction above 0 and at most 1: of 0.6 rad/s for the fastest joint, or of 0.25 m/s
   *     and 1 rad/s for the tool
   */
  record Jog(JogMove move, double speedFraction) implements ManualCommand {}

  /** Ends {@link Jog}: the arm comes to rest on its path. */
  record StopJog() implements ManualCommand {}

  /**
   * Lets the arm be guided by hand as long as this is repeated: at the latest every {@link
   * Jogging#DEAD_MAN_S} of robot time, or the arm holds where it is. Refused while a program runs
   * or is paused, while the arm is stopped or off, and when the declared payload is wrong; the
   * reply to a repetition tells why freedrive has ended.
   *
   * @param axes which axes are free
   * @param frame whose axes these are
   */
  record StartFreedrive(FreeAxes axes, FreedriveFrame frame) implements ManualCommand {}

  /** Ends {@link StartFreedrive}: the arm holds where it is. */
  record EndFreedrive() implements ManualCommand {}

  /** Changes the active TCP; refused while the arm moves or a program runs or is paused. */
  record SetTool(ToolCentre tool) implements ManualCommand {}

  /**
   * Declares the payload; refused while the arm moves or a program runs or is paused. The force
   * sensor is zeroed.
   *
   * @param massKg 0 to four times what the arm is made for, kg
   * @param cogInFlangeM its centre of gravity in the flange frame, m
   * @param inertiaKgM2 about the centre of gravity, along the axes of the flange; empty for that of
   *     a point
   */
  record DeclarePayload(double massKg, Vector3 cogInFlangeM, Optional<Inertia> inertiaKgM2)
      implements ManualCommand {}
}
