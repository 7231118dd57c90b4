package org.pendant.controller;

import java.util.Optional;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.script.vm.Program;

/** Command about programs: start, stop, pause, and secondary ones. */
public sealed interface ProgramCommand extends Command {

  /**
   * Starts a program; refused while another one runs or is paused.
   *
   * @param folder from which it may read files; empty for that of {@link SetProgramsFolder}
   */
  record StartProgram(Program program, Optional<ProgramsFolder> folder) implements ProgramCommand {
    /** A program that reads files where all do. */
    public StartProgram(Program program) {
      this(program, Optional.empty());
    }
  }

  /**
   * Starts a program that a client sent to a port: the one that runs or is paused ends, and the new
   * one starts in the same frame. An arm that still moves continues evenly when the program begins
   * with speeds, servos or a stop; moves wait until it has come to rest on the old path.
   *
   * <p>Refused during any stop of the safety functions, in recovery, and when the controller has
   * been shut down; what ran continues then. Without power the program starts all the same, and
   * fails at its first motion.
   */
  record ReplaceProgram(Program program) implements ProgramCommand {}

  /**
   * Programs that start from now on and bring no folder of their own may read files in this one.
   */
  record SetProgramsFolder(ProgramsFolder folder) implements ProgramCommand {}

  /** Ends the program; the arm comes to rest on its path. */
  record StopProgram() implements ProgramCommand {}

  /** Holds script time; the arm comes to rest on its path. */
  record PauseProgram() implements ProgramCommand {}

  /** Continues after a pause; a popup that caused it closes. */
  record ResumeProgram() implements ProgramCommand {}

  /**
   * Runs a secondary program beside the primary one, to its end (manual 12). Refused as {@link
   * ReplaceProgram} is, when too many others came in the same frame, and while a debugger holds it;
   * the answer to one that ends with an error is {@link Reply.Failed}.
   *
   * @param folder from which it may read files; empty for that of {@link SetProgramsFolder}
   */
  record RunSecondary(Program program, Optional<ProgramsFolder> folder) implements ProgramCommand {
    /** A program that reads files where all do. */
    public RunSecondary(Program program) {
      this(program, Optional.empty());
    }
  }

  /** Ends the move that the main thread waits for early (manual 13.5). */
  record AbortMove() implements ProgramCommand {}
}
