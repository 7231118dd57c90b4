package org.pendant.controller;

import org.pendant.controller.command.Command;

/**
 * Command journal: is told every command that reaches a controller, in the thread that drives it
 * and right before the command is carried out. The same commands at the same places make another
 * controller with the same options do the same. Must be short.
 */
@FunctionalInterface
public interface CommandJournal {
  /**
   * A command comes into force.
   *
   * @param frame that has begun
   * @param turn 0 when it has just begun; while a debugger has paused the program, how many times
   *     it has been continued
   * @param command a {@link DebugCommand.Debug} stands for one {@link
   *     org.pendant.script.debug.DebugRequest}; there is none for what only looks
   */
  void note(long frame, long turn, Command command);
}
