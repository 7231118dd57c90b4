package org.pendant.controller.rtde;

import java.util.Set;
import java.util.function.Consumer;
import org.pendant.controller.command.Command;
import org.pendant.controller.io.IoCommand;

/** Command of an RTDE client about the inputs that it writes. */
public sealed interface RtdeCommand extends Command {

  /**
   * Writes what a package of an RTDE client asks for, all of it or, when another client has taken
   * one of its inputs, nothing; refused with the owner's name then. Also counts for watchdogs.
   *
   * @param writer the name under which {@link ClaimInputs} has taken the inputs
   */
  record WriteInputs(String writer, InputUpdate update) implements RtdeCommand {}

  /**
   * Takes the inputs of a recipe, so that no other client may write them: all of them or, when one
   * is taken, none. {@link IoCommand.ReleaseSignals} gives them back.
   *
   * @param owner such as an RTDE client
   * @param answer is told in the frame loop which inputs are taken by other clients, by their names
   */
  record ClaimInputs(String owner, InputRecipe recipe, Consumer<Set<String>> answer)
      implements RtdeCommand {}
}
