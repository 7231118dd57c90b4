package org.pendant.controller.box;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.command.Command;
import org.pendant.controller.world.HandGrip;
import org.pendant.controller.world.Vector3;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;
import org.pendant.script.value.Value;

/** Command to the simulated world around the arm: what pushes it, is mounted on it or passes by. */
public sealed interface WorldCommand extends Command {

  /**
   * Pushes the tool until told otherwise.
   *
   * @param wrenchAtTcpInBase force and torque at the TCP, along the axes of the base
   */
  record PushTool(Wrench wrenchAtTcpInBase) implements WorldCommand {}

  /**
   * Pushes the arm at a point of one of its links until told otherwise, besides {@link PushTool}. A
   * hand holds one place only: another push or pull takes the place of it.
   *
   * @param link the link that joint {@code link} (0 to 5) moves; 5 is the flange
   * @param pointInLinkM where, in the Denavit-Hartenberg frame after that joint, -4 to 4 m each
   * @param forceInBaseN along the axes of the base, -10,000 to 10,000 N each; all 0 lets go
   */
  record PushLink(int link, Vector3 pointInLinkM, Vector3 forceInBaseN) implements WorldCommand {}

  /**
   * Pulls the arm at a point of one of its links towards a place, with at most {@link
   * HandGrip#MAX_PULL_N} and half of what the motors can give, as long as this is repeated: at the
   * latest every {@link HandGrip#DEAD_MAN_S} of robot time. The arm follows in freedrive; otherwise
   * it resists.
   *
   * @param link as in {@link PushLink}
   * @param pointInLinkM as in {@link PushLink}
   * @param placeInBaseM in the base frame, -100 to 100 m each
   */
  record PullLink(int link, Vector3 pointInLinkM, Vector3 placeInBaseM) implements WorldCommand {}

  /**
   * Carries an object with a mass by hand, as long as this is repeated: at the latest every {@link
   * HandGrip#DEAD_MAN_S} of robot time.
   *
   * @param object its name, or that of a copy such as {@code part #2}
   * @param pointInBaseM where the hand takes it, -100 to 100 m each; counts only when it does not
   *     hold it yet
   * @param placeInBaseM where that point shall go, -100 to 100 m each
   */
  record CarryObject(String object, Vector3 pointInBaseM, Vector3 placeInBaseM)
      implements WorldCommand {}

  /** Ends {@link PushLink}, {@link PullLink} and {@link CarryObject}. */
  record LetGo() implements WorldCommand {}

  /**
   * Hangs something on the flange, whatever programs declare.
   *
   * @param load what it is; empty for what programs declare
   */
  record AttachLoad(Optional<Payload> load) implements WorldCommand {}

  /**
   * Turns an encoder by a simulated belt, without pulses; one that no program has set up counts
   * from then on.
   *
   * @param index 0 or 1
   * @param ticksPerS -1,000,000 to 1,000,000; 0 for a belt that stands
   */
  record RunEncoder(int index, double ticksPerS) implements WorldCommand {}

  /**
   * Puts a part between the fingers of a gripper, or takes it away.
   *
   * @param gripper the name of a device
   * @param widthM 0 for no part
   */
  record PutPart(String gripper, double widthM) implements WorldCommand {}

  /**
   * Sets a signal of the cell.
   *
   * @param signal its name, such as {@code plc.register[3]}
   * @param value 0 or 1 where it is digital
   */
  record SetSignal(String signal, int value) implements WorldCommand {}

  /**
   * Says something to a device of the cell by a connection from outside, and is answered by {@link
   * org.pendant.controller.command.Reply.Told}.
   *
   * @param port at which programs reach the device
   * @param connection a number of the connection
   * @param bytes one {@code char} a byte; empty where nothing has followed what was said before
   */
  record TellDevice(int port, long connection, String bytes) implements WorldCommand {}

  /**
   * Calls a procedure of a device of the cell from outside, and is answered by {@link
   * org.pendant.controller.command.Reply.Returned}.
   *
   * @param port at which programs reach its procedures
   */
  record CallDevice(int port, String method, List<Value> arguments) implements WorldCommand {
    /** Copies the list. */
    public CallDevice {
      arguments = List.copyOf(arguments);
    }
  }

  /** A connection of {@link TellDevice} has ended. */
  record LeaveDevice(int port, long connection) implements WorldCommand {}
}
