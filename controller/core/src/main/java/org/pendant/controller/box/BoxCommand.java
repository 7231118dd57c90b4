package org.pendant.controller.box;

import org.pendant.controller.command.Command;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.IoCommand;

/** Command to the control box as a whole. */
public sealed interface BoxCommand extends Command {

  /** Switches arm and controller off; the thread that drives the frames sees it in the snapshot. */
  record ShutDown() implements BoxCommand {}

  /**
   * The computer could not keep up: robot time has fallen behind the wall clock.
   *
   * @param behindS by how much since the controller was switched on, s
   * @param told whether the log says so, at first and when it has grown much
   */
  record NoteLostTime(double behindS, boolean told) implements BoxCommand {
    /** One that the log tells. */
    public NoteLostTime(double behindS) {
      this(behindS, true);
    }
  }

  /**
   * Moves the speed slider; refused with the owner's name while another client has taken it.
   *
   * @param writer who asks, as in {@link IoCommand.WriteSignals}; it is taken as {@link
   *     InputOwners#SPEED_SLIDER}
   * @param fraction 0 to 1
   */
  record SetSpeedFraction(String writer, double fraction) implements BoxCommand {
    /** A change by hand. */
    public SetSpeedFraction(double fraction) {
      this(InputOwners.BY_HAND, fraction);
    }
  }
}
