package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.pendant.controller.Clock;
import org.pendant.controller.Controller;
import org.pendant.controller.Drive;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.VirtualClock;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/**
 * Headless run: one program on one controller, from its start until the arm is at rest after its
 * end.
 */
final class HeadlessRun {
  /** How often a run at full speed hands over what it has printed, ns. */
  private static final long FLUSH_NS = TimeUnit.MILLISECONDS.toNanos(100);

  /** Frames between two looks at the time; a look costs a few per cent of an idle frame. */
  private static final int FRAMES_PER_LOOK = 16;

  /** An arm that is not at rest by then never will be. */
  private static final int MAX_FRAMES_TO_REST = 5_000;

  private final RunnableFile file;
  private final ProgramReport report;
  private final Robot robot;
  private final Drive drive;
  private final RunOptions options;
  private final Interruption interruption;
  private final WallLimit wall;
  private final Console console;
  private final FrameWatcher watcher;
  private Clock clock;
  private long flushedNs = System.nanoTime();
  private int framesSinceLook;
  private long toldLostNs;

  HeadlessRun(
      RunnableFile file,
      Controller controller,
      RunOptions options,
      Interruption interruption,
      WallLimit wall,
      Console console,
      FrameWatcher watcher) {
    this.file = file;
    report = new ProgramReport(file, controller, console, "");
    robot = controller;
    drive = controller;
    this.options = options;
    this.interruption = interruption;
    this.wall = wall;
    this.console = console;
    this.watcher = watcher;
    clock = options.clock();
  }

  ExitCode run(Program program) {
    report.begin();
    Optional<ProgramsFolder> folder = Optional.of(ProgramsFolder.of(file.file()));
    if (program.secondary()) {
      return runSecondary(new ProgramCommand.RunSecondary(program, folder));
    }
    double endS = options.timeoutS().orElse(Double.POSITIVE_INFINITY);
    if (!options.waveforms().equals(InputWaveforms.NONE)) {
      var _ = robot.submit(new IoCommand.PlayInputs(options.waveforms()));
    }
    Optional<String> refusal = ask(new ProgramCommand.StartProgram(program, folder)).complaint();
    if (refusal.isPresent()) {
      report.errorFromEnglish(refusal.get());
      return ExitCode.PROGRAM_FAILED;
    }
    Optional<String> timedOut = Optional.empty();
    while (drive.program().state() != ProgramState.STOPPED) {
      timedOut = timedOut(endS);
      if (timedOut.isPresent()
          || interruption.requested()
          || console.outputClosed()
          || watcher.enough()) {
        stop();
      } else if (drive.program().state() == ProgramState.PAUSED) {
        resumeOrStop();
      } else {
        advance();
      }
    }
    comeToRest();
    return timedOut.isPresent() ? report.timedOut(timedOut.get()) : report.ended();
  }

  /** Which time limit is over. */
  private Optional<String> timedOut(double endS) {
    if (drive.timeS() >= endS) {
      return Optional.of(text("timeLimitOver", endS));
    }
    return wall.over()
        ? Optional.of(text("wallLimitOver", wall.limitS().orElseThrow()))
        : Optional.empty();
  }

  private ExitCode runSecondary(ProgramCommand.RunSecondary program) {
    Reply reply = ask(program);
    // why it failed is in the log, which is printed with everything else
    if (!(reply instanceof Reply.Failed)) {
      reply.complaint().ifPresent(report::errorFromEnglish);
    }
    return reply instanceof Reply.Done ? ExitCode.DONE : ExitCode.PROGRAM_FAILED;
  }

  private void stop() {
    Optional<String> refusal = ask(new ProgramCommand.StopProgram()).complaint();
    if (refusal.isPresent()) {
      throw new IllegalStateException("a running program cannot be stopped: " + refusal.get());
    }
  }

  /** No operator is here to end a safety stop: the program ends with it. */
  private void resumeOrStop() {
    if (safetyStop().isEmpty()) {
      resume();
      return;
    }
    report.stoppedBy(safetyStop().get());
    stop();
  }

  private Optional<SafetyStop> safetyStop() {
    return robot.state().safety().stop();
  }

  private void resume() {
    report.complain(
        Report.note(report.source(), text("pausedContinues", robot.state().program().line())));
    Optional<String> refusal = ask(new ProgramCommand.ResumeProgram()).complaint();
    if (refusal.isPresent()) {
      throw new IllegalStateException("a paused program cannot be resumed: " + refusal.get());
    }
  }

  /** Has the controller carry out a command in the next frame. */
  private Reply ask(Command command) {
    CompletableFuture<Reply> reply = robot.submit(command);
    advance();
    return reply.join();
  }

  /** As fast as possible: no user wants to wait for a run that is over. */
  private void comeToRest() {
    clock = new VirtualClock();
    for (int i = 0; i < MAX_FRAMES_TO_REST && robot.state().arm().moving(); i++) {
      advance();
    }
  }

  /** One frame, and what it brought to print and record. */
  private void advance() {
    try {
      clock.awaitDue(drive::waitsForOutside);
    } catch (InterruptedException e) {
      throw new IllegalStateException("nobody interrupts the thread that runs the frames", e);
    }
    tellLost();
    drive.advance();
    report.passes(drive.program().line());
    if (drive.broughtMessages() || watcher.looks()) {
      show(robot.state());
    }
    flush();
  }

  private void tellLost() {
    if (clock.lostNs() != toldLostNs) {
      toldLostNs = clock.lostNs();
      var _ = robot.submit(new BoxCommand.NoteLostTime(toldLostNs * 1e-9));
    }
  }

  /** What a frame has brought. */
  private void show(ControllerState state) {
    report.show(state);
    if (watcher.looks()) {
      watcher.see(state);
    }
  }

  /** On the wall clock each line goes out at once; at full speed now and then. */
  private void flush() {
    if (!report.pendingOutput()) {
      return;
    }
    boolean due = options.speedFactor().isPresent();
    framesSinceLook = (framesSinceLook + 1) % FRAMES_PER_LOOK;
    if (!due && framesSinceLook == 0) {
      due = System.nanoTime() - flushedNs > FLUSH_NS;
    }
    if (due) {
      console.flush();
      flushedNs = System.nanoTime();
      report.flushed();
    }
  }
}
