package org.pendant.recording.replay;

import java.util.Optional;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.InstallationCommand;
import org.pendant.controller.InterpreterCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.eip.AssemblyCommand;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.rtde.RtdeCommand;
import org.pendant.script.debug.DebugRequest;
import org.pendant.script.vm.Program;

/**
 * Kept command: a command as a journal keeps it, as data that can be given to another controller.
 * All kinds are immutable but for those whose answer is given to a client; that part is left out.
 * Those that carry more than a few numbers are named here with what they take.
 *
 * @param bytes about what it takes in memory
 */
record KeptCommand(Command command, int bytes) {
  /** Object, place and fingerprint. */
  private static final int PLAIN = 96;

  /** What hangs on a character of a program: its tree, instructions and tables. */
  private static final int BYTES_PER_CHARACTER = 40;

  private static final int BYTES_PER_SIGNAL = 48;
  private static final int INSTALLATION = 16_384;

  /** How {@code command} is kept; empty if it cannot change a controller. */
  static Optional<KeptCommand> of(Command command) {
    return switch (command) {
      case InterpreterCommand.AskInterpreter ask -> Optional.empty();
      case RtdeCommand.ClaimInputs claim ->
          kept(
              new RtdeCommand.ClaimInputs(claim.owner(), claim.recipe(), taken -> {}),
              BYTES_PER_SIGNAL * claim.recipe().fields().size());
      case DebugCommand.Debug debug ->
          debug.request() instanceof DebugRequest ? kept(debug, 0) : Optional.empty();
      case ProgramCommand.StartProgram start -> kept(start, size(start.program()));
      case ProgramCommand.ReplaceProgram replace -> kept(replace, size(replace.program()));
      case ProgramCommand.RunSecondary secondary -> kept(secondary, size(secondary.program()));
      case InterpreterCommand.Interpret line -> kept(line, size(line.line().text()));
      case IoCommand.WriteSignals write -> kept(write, BYTES_PER_SIGNAL * write.writes().size());
      case IoCommand.PlayInputs play ->
          kept(play, 2 * BYTES_PER_SIGNAL * play.waveforms().changes().size());
      case RtdeCommand.WriteInputs write ->
          kept(write, BYTES_PER_SIGNAL * (2 + write.update().writes().size()));
      case AssemblyCommand.ReceiveAssembly got -> kept(got, got.data().size());
      case InstallationCommand.ApplyInstallation apply -> kept(apply, INSTALLATION);
      case MessageCommand.ShowPopup show ->
          kept(show, show.title().length() + show.text().length());
      case MessageCommand.WriteLog write -> kept(write, write.text().length());
      case DebugCommand.TraceVariables trace ->
          kept(trace, BYTES_PER_SIGNAL * trace.paths().size());
      default -> kept(command, 0);
    };
  }

  private static Optional<KeptCommand> kept(Command command, int more) {
    return Optional.of(new KeptCommand(command, PLAIN + more));
  }

  private static int size(Program program) {
    return size(program.source().text());
  }

  private static int size(String text) {
    return (int) Math.min(Integer.MAX_VALUE / 2, (long) BYTES_PER_CHARACTER * text.length());
  }
}
