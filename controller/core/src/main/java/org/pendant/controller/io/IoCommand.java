package org.pendant.controller.io;

import java.util.List;
import org.pendant.controller.command.Command;

/** Command about inputs, outputs and registers, and who may write them. */
public sealed interface IoCommand extends Command {

  /**
   * Sets a digital input.
   *
   * @param name such as {@code digital_in[0]}, {@code configurable_in[3]} or {@code tool_in[1]}
   */
  record SetInput(String name, boolean level) implements IoCommand {}

  /**
   * Changes signals, all of them or, when one is refused, none. A signal that another client has
   * taken is refused with the owner's name. By hand, outputs are refused while a program runs or is
   * paused.
   *
   * @param writer who asks: the name under which {@link ClaimSignal} takes signals, or {@link
   *     InputOwners#BY_HAND}
   */
  record WriteSignals(String writer, List<SignalWrite> writes) implements IoCommand {
    /** Copies the list. */
    public WriteSignals {
      writes = List.copyOf(writes);
    }

    /** A change by hand. */
    public WriteSignals(SignalWrite write) {
      this(InputOwners.BY_HAND, List.of(write));
    }
  }

  /**
   * Takes a signal, so that no other client may write it; refused with the owner's name when it is
   * taken.
   *
   * @param owner such as an RTDE client
   * @param signal see {@link InputOwners}
   */
  record ClaimSignal(String owner, String signal) implements IoCommand {}

  /**
   * Plays waveforms at the inputs by the time since a program began: since the one that runs, and
   * each that follows; {@link InputWaveforms#NONE} plays none any more.
   */
  record PlayInputs(InputWaveforms waveforms) implements IoCommand {}

  /** Gives back all signals that {@code owner} has taken. */
  record ReleaseSignals(String owner) implements IoCommand {}
}
