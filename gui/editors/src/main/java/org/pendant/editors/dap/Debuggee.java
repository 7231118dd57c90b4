package org.pendant.editors.dap;

import org.pendant.editors.dap.run.DebugTarget;
import org.pendant.editors.dap.run.RobotRun;
import org.pendant.script.vm.Program;

/**
 * Debuggee: the program that a session is about, and its robot.
 *
 * @param arguments by which the client asked for it
 */
record Debuggee(
    LaunchArguments arguments,
    DebugTarget target,
    Program program,
    DebuggedText text,
    RobotRun run,
    RunEvents events) {}
