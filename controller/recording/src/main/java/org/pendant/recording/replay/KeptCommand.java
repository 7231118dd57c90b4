package org.pendant.recording.replay;

import java.util.Optional;
import org.pendant.controller.Command;
import org.pendant.script.debug.DebugRequest;
import org.pendant.script.vm.Program;

/**
 * A command as a journal keeps it: as data that can be given to another controller. All kinds are
 * immutable but for those whose answer goes to somebody; that part is left out.
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
      case Command.AskInterpreter ask -> Optional.empty();
      case Command.ClaimInputs claim ->
          kept(
              new Command.ClaimInputs(claim.owner(), claim.recipe(), taken -> {}),
              BYTES_PER_SIGNAL * claim.recipe().fields().size());
      case Command.Debug debug ->
          debug.request() instanceof DebugRequest ? kept(debug, 0) : Optional.empty();
      case Command.StartProgram start -> kept(start, size(start.program()));
      case Command.ReplaceProgram replace -> kept(replace, size(replace.program()));
      case Command.RunSecondary secondary -> kept(secondary, size(secondary.program()));
      case Command.Interpret line -> kept(line, size(line.line().text()));
      case Command.WriteSignals write -> kept(write, BYTES_PER_SIGNAL * write.writes().size());
      case Command.WriteInputs write ->
          kept(write, BYTES_PER_SIGNAL * (2 + write.update().writes().size()));
      case Command.ReceiveAssembly got -> kept(got, got.data().size());
      case Command.ApplyInstallation apply -> kept(apply, INSTALLATION);
      case Command.ShowPopup show -> kept(show, show.title().length() + show.text().length());
      case Command.WriteLog write -> kept(write, write.text().length());
      case Command.TraceVariables trace -> kept(trace, BYTES_PER_SIGNAL * trace.paths().size());
      case Command.SetProgramsFolder _,
          Command.StopProgram _,
          Command.PauseProgram _,
          Command.ResumeProgram _,
          Command.SetInput _,
          Command.ClaimSignal _,
          Command.ConfigureAssemblies _,
          Command.ReleaseSignals _,
          Command.ScannerLost _,
          Command.RunEncoder _,
          Command.SetSpeedFraction _,
          Command.AnswerPopup _,
          Command.NoteLostTime _,
          Command.AnswerQuestion _,
          Command.CancelQuestion _,
          Command.SkipInterpreted _,
          Command.AbortMove _,
          Command.ShutDown _,
          Command.PowerOn _,
          Command.PowerOff _,
          Command.ReleaseBrakes _,
          Command.UnlockProtectiveStop _,
          Command.RestartSafety _,
          Command.StartBackdrive _,
          Command.EndBackdrive _,
          Command.SetManualMode _,
          Command.SetSafetyInput _,
          Command.PushTool _,
          Command.PushLink _,
          Command.PullLink _,
          Command.LetGo _,
          Command.StartFreedrive _,
          Command.EndFreedrive _,
          Command.AttachLoad _,
          Command.Jog _,
          Command.StopJog _,
          Command.SetTool _,
          Command.DeclarePayload _ ->
          kept(command, 0);
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
