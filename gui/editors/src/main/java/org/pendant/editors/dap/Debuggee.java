package org.pendant.editors.dap;

import org.pendant.editors.dap.run.DebuggedRobot;
import org.pendant.script.vm.Program;

/**
 * Debuggee: the program that a session is about, and its robot.
 *
 * @param arguments by which the client asked for it
 */
record Debuggee(
    LaunchArguments arguments,
    Program program,
    DebuggedText text,
    DebuggedRobot run,
    RunEvents events) {
  /** Where its program moves the arm. */
  Moves moves() {
    return Moves.of(program);
  }
}
