package org.pendant.editors.dryrun;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StopPlace;
import org.pendant.editors.dryrun.DryRunResult.Outcome;
import org.pendant.editors.dryrun.DryRunResult.Trouble;
import org.pendant.language.source.Source;
import org.pendant.recording.lines.LineProfiler;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/**
 * Dry run: runs a program from the upright start position of a robot that has just been switched
 * on, with all inputs off, without files and without anything outside, as fast as the processor
 * goes.
 */
public final class DryRun {
  /** Frames between two looks at the time and at whether somebody still wants to know. */
  private static final int FRAMES_PER_LOOK = 64;

  private static final double NS_PER_S = 1e9;

  /** Errors of a program that asks for something outside, or for a person: there is none here. */
  private static final Set<String> NOBODY_THERE = Set.of("no-outside", "no-answer");

  private final Controller controller;
  private final LineProfiler profiler;
  private final DryRunLimits limits;
  private final BooleanSupplier cancelled;
  private int lastLine;

  private DryRun(String robotId, DryRunLimits limits, BooleanSupplier cancelled) {
    controller =
        new Controller(
            ControllerOptions.headless()
                .withRobot(robotId)
                .withOperator(Operator.headless(List.of())));
    profiler = new LineProfiler(controller::programSource, controller::safety);
    this.limits = limits;
    this.cancelled = cancelled;
  }

  /**
   * Runs {@code source} in the calling thread.
   *
   * @param robotId which arm
   * @param cancelled ends it early, as at a time limit
   */
  public static DryRunResult of(
      Source source, String robotId, DryRunLimits limits, BooleanSupplier cancelled) {
    DryRun run = new DryRun(robotId, limits, cancelled);
    Optional<Program> program = run.controller.load(source).program();
    return program.filter(each -> !each.secondary()).map(run::run).orElse(DryRunResult.notRun());
  }

  private DryRunResult run(Program program) {
    if (!(tell(new ProgramCommand.StartProgram(program)) instanceof Reply.Done)) {
      return DryRunResult.notRun();
    }
    long endNs = System.nanoTime() + limits.wallTime().toNanos();
    double endS = controller.state().timeS() + limits.robotTime().toNanos() / NS_PER_S;
    Optional<SafetyStop> heldBy = Optional.empty();
    for (int i = 1; state().program().state() != ProgramState.STOPPED; i++) {
      if (state().program().state() == ProgramState.PAUSED) {
        heldBy = state().safety().stop();
        if (heldBy.isPresent()
            || !(tell(new ProgramCommand.ResumeProgram()) instanceof Reply.Done)) {
          break;
        }
      }
      boolean look = i % FRAMES_PER_LOOK == 0;
      if (look && (over(endNs, endS) || cancelled.getAsBoolean())) {
        return result(Outcome.GIVEN_UP, Optional.empty());
      }
      advance();
    }
    return ended(heldBy.or(() -> state().safety().stop()));
  }

  private boolean over(long endNs, double endS) {
    return System.nanoTime() >= endNs || state().timeS() >= endS;
  }

  private DryRunResult ended(Optional<SafetyStop> stop) {
    if (stop.isPresent()) {
      return result(
          Outcome.STOPPED,
          Optional.of(new Trouble(stoppedInLine(), Optional.empty(), stop.get().message())));
    }
    if (state().program().ending().orElse(new Ending.Finished())
        instanceof Ending.Failed(var failure)) {
      if (NOBODY_THERE.contains(failure.code())) {
        return result(Outcome.GIVEN_UP, Optional.empty());
      }
      return result(
          Outcome.FAILED,
          Optional.of(
              new Trouble(failure.line(), Optional.of(failure.range()), failure.message())));
    }
    return state()
        .arm()
        .fault()
        .map(
            fault ->
                result(
                    Outcome.STOPPED,
                    Optional.of(new Trouble(lastLine, Optional.empty(), fault.message()))))
        .orElseGet(() -> result(Outcome.FINISHED, Optional.empty()));
  }

  /** The line of the program that a safety stop met, or the last one that it reached. */
  private int stoppedInLine() {
    return state()
        .safety()
        .stopPlace()
        .map(StopPlace::line)
        .filter(line -> line > 0)
        .orElse(lastLine);
  }

  private DryRunResult result(Outcome outcome, Optional<Trouble> trouble) {
    var profile = profiler.profile();
    return new DryRunResult(outcome, trouble, profile.timeS(), profile.lines());
  }

  private Reply tell(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    advance();
    return reply.join();
  }

  private void advance() {
    controller.advance();
    profiler.see(state());
    if (state().program().line() > 0) {
      lastLine = state().program().line();
    }
  }

  private ControllerState state() {
    return controller.state();
  }
}
