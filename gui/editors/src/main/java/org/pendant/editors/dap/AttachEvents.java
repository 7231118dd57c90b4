package org.pendant.editors.dap;

import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.state.ControllerState;
import org.pendant.editors.dap.run.RunListener;
import org.pendant.editors.dap.run.RunResult;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramEvent;

/** Attach events: tells a client of a robot on which others start programs. */
final class AttachEvents implements RunListener {
  private final DebugSession session;
  private final RunEvents events;
  private final Runnable started;
  private final Consumer<RunResult> ended;

  /**
   * Events of a robot.
   *
   * @param events tells what does not depend on who starts programs
   * @param started is run in the session's turn when a program has begun
   * @param ended is told there how one has ended
   */
  AttachEvents(
      DebugSession session, RunEvents events, Runnable started, Consumer<RunResult> ended) {
    this.session = session;
    this.events = events;
    this.started = started;
    this.ended = ended;
  }

  @Override
  public void frame(ControllerState state) throws InterruptedException {
    for (ProgramEvent each : state.newProgramEvents()) {
      switch (each) {
        case ProgramEvent.Started _ -> session.thread().event(started);
        case ProgramEvent.Ended end -> {
          RunResult result = result(end.ending());
          session.thread().event(() -> ended.accept(result));
        }
        case ProgramEvent.SecondaryFailed _ -> {
          // the log has it
        }
      }
    }
    events.frame(state);
  }

  private static RunResult result(Ending ending) {
    return ending instanceof Ending.Failed(var failure)
        ? new RunResult(
            RunResult.PROGRAM_FAILED, Optional.of(failure), Optional.empty(), failure.line())
        : new RunResult(RunResult.DONE, Optional.empty(), Optional.empty(), 0);
  }

  @Override
  public void safetyStop(ControllerState state) {
    events.safetyStop(state);
  }

  @Override
  public void wentOn() {
    events.wentOn();
  }

  @Override
  public void note(String text) {
    events.note(text);
  }

  @Override
  public void over(RunResult result) {
    events.over(result);
  }

  @Override
  public void failed(Throwable fault) {
    events.failed(fault);
  }
}
