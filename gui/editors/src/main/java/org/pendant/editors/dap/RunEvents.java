package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.eclipse.lsp4j.debug.ExitedEventArguments;
import org.eclipse.lsp4j.debug.OutputEventArguments;
import org.eclipse.lsp4j.debug.OutputEventArgumentsCategory;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.eclipse.lsp4j.debug.StoppedEventArgumentsReason;
import org.eclipse.lsp4j.debug.TerminatedEventArguments;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.editors.dap.look.EndedView;
import org.pendant.editors.dap.look.LiveView;
import org.pendant.editors.dap.run.DataWatch;
import org.pendant.editors.dap.run.DebuggedRobot;
import org.pendant.editors.dap.run.RunListener;
import org.pendant.editors.dap.run.RunResult;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.Debugger;
import org.pendant.script.debug.PauseReason;

/** Run events: tells the client what its program does, in the turns of the session. */
final class RunEvents implements RunListener {
  /** Why a program that has ended stands still. */
  private static final String ENDED = "ended";

  private final DebugSession session;
  private final StopKinds stops;
  private final StopWishes wishes;
  private final Supplier<OutputEvents> output;
  private final WrittenLines written = new WrittenLines();
  private Optional<RunResult> atEnd = Optional.empty();
  private boolean toEnd;
  private long toldStop;

  /** Only for the thread that tells of frames. */
  private boolean held;

  private long toldEntry;

  /** Only for the thread of the session. */
  private boolean detached;

  RunEvents(
      DebugSession session, StopKinds stops, StopWishes wishes, Supplier<OutputEvents> output) {
    this.session = session;
    this.stops = stops;
    this.wishes = wishes;
    this.output = output;
  }

  @Override
  public void frame(ControllerState state) throws InterruptedException {
    List<OutputEventArguments> said = output.get().of(state, toldEntry);
    written.add(state, toldEntry);
    toldEntry = Math.max(toldEntry, state.newestEntry());
    if (!said.isEmpty()) {
      session.thread().event(() -> said.forEach(session.client()::output));
    }
    Optional<DebugState.Stop> stop = state.debug().stop();
    if (held && stop.isEmpty()) {
      // where nobody has asked for it here, others have let it go on
      session.thread().event(this::tellThatItWentOn);
    }
    held = stop.isPresent();
    if (stop.isPresent() && stop.get().number() != toldStop) {
      toldStop = stop.get().number();
      session.thread().event(() -> stopped(state, stop.get()));
    }
  }

  /** What was written, and when. */
  WrittenLines written() {
    return written;
  }

  /** Nothing is told any more: the session has done with this run. */
  void detach() {
    detached = true;
  }

  /** The run, as long as the session is about it. */
  private Optional<DebuggedRobot> run() {
    return session.debuggee().map(Debuggee::run).filter(run -> !detached);
  }

  private void stopped(ControllerState state, DebugState.Stop stop) {
    if (run().isEmpty()) {
      return;
    }
    StoppedEventArguments told = told(stop);
    told.setThreadId(DebugSession.number(stop.thread()));
    session.stop(new LiveView(run().get(), state, state.debug().threads()), told);
  }

  private StoppedEventArguments told(DebugState.Stop stop) {
    StoppedEventArguments told = new StoppedEventArguments();
    // whatever stops it first, nothing is expected any more
    StopWishes.Pause asked = wishes.takePause();
    StopWishes.Step step = wishes.takeStep();
    switch (stop.reason()) {
      case PauseReason.AtBreakpoint(int line, long _) -> {
        BreakpointTable.Hit hit = stops.lines().at(line);
        told.setReason(
            hit.lines().isEmpty() && !hit.functions().isEmpty()
                ? StoppedEventArgumentsReason.FUNCTION_BREAKPOINT
                : StoppedEventArgumentsReason.BREAKPOINT);
        told.setHitBreakpointIds(hit.ids());
      }
      case PauseReason.ConditionFailed(int line, String message) -> {
        told.setReason(StoppedEventArgumentsReason.BREAKPOINT);
        told.setDescription(text("conditionFailed"));
        told.setText(ByteText.decoded(message));
        told.setHitBreakpointIds(stops.lines().at(line).ids());
      }
      case PauseReason.Stepped _ -> {
        told.setReason(step.reason());
        if (step == StopWishes.Step.MOVE) {
          told.setDescription(text("pausedAtMove", session.program().moves().words(stop.line())));
        }
      }
      case PauseReason.PauseRequested _ -> {
        List<DataWatch.Change> changes = stops.data().changes();
        if (!changes.isEmpty()) {
          changed(told, changes);
          break;
        }
        told.setReason(asked.reason());
        told.setDescription(asked.description());
      }
      case PauseReason.Failed(var failure) -> {
        told.setReason(StoppedEventArgumentsReason.EXCEPTION);
        told.setDescription(text("programFailed"));
        told.setText(ByteText.decoded(failure.message()));
      }
    }
    return told;
  }

  private static void changed(StoppedEventArguments told, List<DataWatch.Change> changes) {
    told.setReason(StoppedEventArgumentsReason.DATA_BREAKPOINT);
    told.setDescription(
        changes.stream().map(DataWatch.Change::words).collect(Collectors.joining("; ")));
    told.setHitBreakpointIds(changes.stream().map(DataWatch.Change::id).toArray(Integer[]::new));
  }

  @Override
  public void safetyStop(ControllerState state) {
    session.thread().execute(() -> safetyStopped(state));
  }

  private void safetyStopped(ControllerState state) {
    if (run().isEmpty()) {
      return;
    }
    DebuggedRobot run = run().get();
    StoppedEventArguments told = new StoppedEventArguments();
    told.setReason(StoppedEventArgumentsReason.EXCEPTION);
    told.setDescription(text("safetyStopped"));
    told.setText(state.safety().stop().map(SafetyStop::message).orElse(""));
    told.setThreadId(DebugSession.number(Debugger.MAIN));
    var _ =
        run.ask(Debugger::threads)
            .thenAccept(threads -> session.stop(new LiveView(run, state, threads), told));
  }

  @Override
  public void wentOn() {
    session.thread().execute(this::tellThatItWentOn);
  }

  private void tellThatItWentOn() {
    if (run().isPresent() && session.view().isPresent()) {
      session.goOn();
      session.tellContinued();
    }
  }

  @Override
  public void note(String text) {
    session.thread().execute(() -> session.client().output(output.get().note(text)));
  }

  @Override
  public void over(RunResult result) {
    session.thread().execute(() -> over(result, run()));
  }

  private void over(RunResult result, Optional<DebuggedRobot> run) {
    boolean held =
        session
            .debuggee()
            .map(Debuggee::arguments)
            .filter(each -> each.stopAtEnd() && !each.noDebug())
            .isPresent();
    if (run.isEmpty() || !held || toEnd) {
      ended(result);
      return;
    }
    atEnd = Optional.of(result);
    StoppedEventArguments told = new StoppedEventArguments();
    told.setReason(ENDED);
    told.setDescription(text("programEnded"));
    told.setThreadId(DebugSession.number(Debugger.MAIN));
    session.stop(
        EndedView.of(
            run.get().recording(), run.get().robot().state(), session.program().text().source()),
        told);
  }

  /** The program is to end, and nobody wants to look back at it. */
  void endForGood() {
    toEnd = true;
    leaveEnd();
  }

  /** Has done with a program that has ended. */
  void leaveEnd() {
    Optional<RunResult> result = atEnd;
    atEnd = Optional.empty();
    result.ifPresent(this::ended);
  }

  private void ended(RunResult result) {
    if (detached) {
      return;
    }
    output.get().of(result).ifPresent(session.client()::output);
    session.goOn();
    session.tellThreads(List.of());
    ExitedEventArguments exited = new ExitedEventArguments();
    exited.setExitCode(result.exitCode());
    session.client().exited(exited);
    session.client().terminated(new TerminatedEventArguments());
  }

  @Override
  public void failed(Throwable fault) {
    session
        .thread()
        .execute(
            () -> {
              session
                  .client()
                  .output(
                      OutputEvents.output(
                          OutputEventArgumentsCategory.STDERR,
                          session.form().shown(text("internalError", fault))));
              ended(new RunResult(RunResult.INTERNAL_ERROR, Optional.empty(), Optional.empty(), 0));
            });
  }
}
