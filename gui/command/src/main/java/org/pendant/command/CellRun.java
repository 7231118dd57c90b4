package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.pendant.controller.Cell;
import org.pendant.controller.Clock;
import org.pendant.controller.Controller;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.VirtualClock;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/**
 * Cell run: the programs of all controllers of a cell, which begin in the same frame, until those
 * of the arms have ended or one has failed. The cell's script ends with them.
 */
final class CellRun {
  /** How often a run at full speed hands over what it has printed, ns. */
  private static final long FLUSH_NS = TimeUnit.MILLISECONDS.toNanos(100);

  private static final int FRAMES_PER_LOOK = 16;

  /** An arm that is not at rest by then never will be. */
  private static final int MAX_FRAMES_TO_REST = 5_000;

  /**
   * A program on its controller.
   *
   * @param member the controller
   * @param report takes what it says
   * @param program what runs there
   * @param watcher sees its frames
   */
  record Part(Cell.Member member, ProgramReport report, Program program, FrameWatcher watcher) {
    private Controller controller() {
      return member.controller();
    }

    private ControllerState state() {
      return controller().state();
    }

    private boolean stopped() {
      return controller().program().state() == ProgramState.STOPPED;
    }
  }

  private final Cell cell;
  private final List<Part> parts;
  private final RunOptions options;
  private final Interruption interruption;
  private final WallLimit wall;
  private final Console console;
  private Clock clock;
  private long toldLostNs;
  private int framesSinceLook;
  private long flushedNs = System.nanoTime();

  /**
   * Runs programs in a cell.
   *
   * @param parts the controllers that run something, in their order, at least one of them an arm's
   */
  CellRun(
      Cell cell,
      List<Part> parts,
      RunOptions options,
      Interruption interruption,
      WallLimit wall,
      Console console) {
    this.cell = cell;
    this.parts = List.copyOf(parts);
    this.options = options;
    this.interruption = interruption;
    this.wall = wall;
    this.console = console;
    clock = options.clock();
  }

  ExitCode run() {
    parts.forEach(part -> part.report().begin());
    if (!start()) {
      return ExitCode.PROGRAM_FAILED;
    }
    double endS = options.timeoutS().orElse(Double.POSITIVE_INFINITY);
    Optional<String> timedOut = Optional.empty();
    Optional<Part> broken = Optional.empty();
    boolean told = false;
    while (!arms().allMatch(Part::stopped) && timedOut.isEmpty() && broken.isEmpty() && !told) {
      advance();
      timedOut = timedOut(endS);
      broken = parts.stream().filter(this::broken).findFirst();
      told =
          interruption.requested()
              || console.outputClosed()
              || parts.stream().anyMatch(part -> part.watcher().enough());
    }
    List<Part> cutOff = parts.stream().filter(part -> !part.stopped()).toList();
    for (Part part : cutOff) {
      var _ = part.controller().submit(new ProgramCommand.StopProgram());
    }
    advance();
    comeToRest();
    return ended(timedOut, broken, cutOff);
  }

  private Stream<Part> arms() {
    return parts.stream().filter(part -> !part.member().armless());
  }

  /** All programs begin in the same frame. */
  private boolean start() {
    if (!options.waveforms().equals(InputWaveforms.NONE)) {
      var _ = parts.getFirst().controller().submit(new IoCommand.PlayInputs(options.waveforms()));
    }
    List<CompletableFuture<Reply>> replies = new ArrayList<>();
    for (Part part : parts) {
      Optional<ProgramsFolder> folder =
          Optional.of(ProgramsFolder.of(part.program().source().name()));
      replies.add(
          part.controller().submit(new ProgramCommand.StartProgram(part.program(), folder)));
    }
    advance();
    boolean all = true;
    for (int i = 0; i < parts.size(); i++) {
      Optional<String> refusal = replies.get(i).join().complaint();
      refusal.ifPresent(parts.get(i).report()::errorFromEnglish);
      all &= refusal.isEmpty();
    }
    return all;
  }

  /** Whether a program has failed, or is held by a stop that nobody is here to end. */
  private boolean broken(Part part) {
    ProgramState now = part.controller().program().state();
    if (now == ProgramState.RUNNING) {
      return false;
    }
    ControllerState state = part.state();
    if (now == ProgramState.PAUSED) {
      Optional<SafetyStop> stop = state.safety().stop();
      if (stop.isEmpty()) {
        part.report()
            .complain(
                Report.note(
                    part.report().source(), text("pausedContinues", state.program().line())));
        var _ = part.controller().submit(new ProgramCommand.ResumeProgram());
        return false;
      }
      part.report().stoppedBy(stop.get());
      return true;
    }
    return part.stopped()
        && (state.program().ending().orElse(null) instanceof Ending.Failed
            || state.safety().stop().isPresent());
  }

  /** Which time limit is over. */
  private Optional<String> timedOut(double endS) {
    if (parts.getFirst().controller().timeS() >= endS) {
      return Optional.of(text("timeLimitOver", endS));
    }
    return wall.over()
        ? Optional.of(text("wallLimitOver", wall.limitS().orElseThrow()))
        : Optional.empty();
  }

  /** As fast as possible: no user wants to wait for a run that is over. */
  private void comeToRest() {
    clock = new VirtualClock();
    for (int i = 0; i < MAX_FRAMES_TO_REST && moving(); i++) {
      advance();
    }
  }

  private boolean moving() {
    return arms().anyMatch(part -> part.state().arm().moving());
  }

  private ExitCode ended(Optional<String> timedOut, Optional<Part> broken, List<Part> cutOff) {
    ExitCode code = ExitCode.DONE;
    for (Part part : parts) {
      boolean first = broken.isPresent() && broken.get().equals(part);
      boolean cut = cutOff.contains(part) && !first;
      if (cut && timedOut.isPresent()) {
        code = code.or(part.report().timedOut(timedOut.get()));
      } else if (cut && broken.isPresent() && part.state().safety().stop().isEmpty()) {
        part.report()
            .complain(
                Report.note(
                    part.report().source(),
                    text("stoppedWithOther", broken.get().member().name())));
      } else {
        code = code.or(part.report().ended());
      }
    }
    return code;
  }

  /** One frame of all, and what it brought to print and record. */
  private void advance() {
    try {
      clock.awaitDue(cell::waitsForOutside);
    } catch (InterruptedException e) {
      throw new IllegalStateException("nobody interrupts the thread that runs the frames", e);
    }
    if (clock.lostNs() != toldLostNs) {
      toldLostNs = clock.lostNs();
      cell.noteLostTime(toldLostNs * 1e-9);
    }
    cell.advance();
    boolean pending = false;
    for (Part part : parts) {
      Controller controller = part.controller();
      part.report().passes(controller.program().line());
      if (controller.broughtMessages() || part.watcher().looks()) {
        part.report().show(controller.state());
      }
      if (part.watcher().looks()) {
        part.watcher().see(controller.state());
      }
      pending |= part.report().pendingOutput();
    }
    if (pending) {
      flush();
    }
  }

  /** On the wall clock each line goes out at once; at full speed now and then. */
  private void flush() {
    boolean due = options.speedFactor().isPresent();
    framesSinceLook = (framesSinceLook + 1) % FRAMES_PER_LOOK;
    if (!due && framesSinceLook == 0) {
      due = System.nanoTime() - flushedNs > FLUSH_NS;
    }
    if (due) {
      console.flush();
      flushedNs = System.nanoTime();
      parts.forEach(part -> part.report().flushed());
    }
  }
}
