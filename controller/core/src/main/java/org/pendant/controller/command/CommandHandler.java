package org.pendant.controller.command;

/**
 * Handler of one family of commands, in the thread that drives the frames.
 *
 * @param <C> a sealed interface whose records are the commands
 */
public interface CommandHandler<C extends Command> {
  /** The family that it carries out. */
  Class<C> family();

  /**
   * Carries out a command. An {@link IllegalArgumentException} refuses it with its message; nothing
   * has changed then.
   */
  Reply carryOut(C command);
}
