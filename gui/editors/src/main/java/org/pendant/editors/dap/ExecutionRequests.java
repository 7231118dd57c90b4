package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.eclipse.lsp4j.debug.ContinueResponse;
import org.eclipse.lsp4j.debug.SteppingGranularity;
import org.pendant.editors.dap.look.EndedView;
import org.pendant.editors.dap.look.PastView;
import org.pendant.script.debug.Debugger;

/** Requests that let a program go on, and that stop it. */
final class ExecutionRequests {
  private final DebugSession session;
  private final StopWishes wishes;
  private final PastRequests past;

  ExecutionRequests(DebugSession session, StopWishes wishes, PastRequests past) {
    this.past = past;
    this.session = session;
    this.wishes = wishes;
  }

  CompletableFuture<ContinueResponse> resume() {
    ContinueResponse response = new ContinueResponse();
    response.setAllThreadsContinued(true);
    if (past.past()) {
      return past.resume().thenApply(done -> response);
    }
    if (ended()) {
      leaveEnd();
      return CompletableFuture.completedFuture(response);
    }
    if (session.program().run().atSafetyStop()) {
      session.goOn();
      session.program().run().leaveSafetyStop();
      return CompletableFuture.completedFuture(response);
    }
    return go(Debugger::resume).thenApply(done -> response);
  }

  private boolean ended() {
    return session.view().filter(EndedView.class::isInstance).isPresent();
  }

  /** Nothing follows the end; that is told behind the answer to the request. */
  private void leaveEnd() {
    session.thread().execute(session.program().events()::leaveEnd);
  }

  /** Back to where a line of output was written, or on to there. */
  CompletableFuture<Void> toMoment(int id) {
    return session
        .program()
        .events()
        .written()
        .of(id)
        .map(past::to)
        .orElseGet(() -> Refusals.answer(text("outputForgotten")));
  }

  /**
   * To a robot time of the recording.
   *
   * @param timeS robot time, s
   */
  CompletableFuture<Void> toTime(double timeS) {
    return past.to(timeS);
  }

  /** Gives up what a request looks for in the recording. */
  void cancel(int request) {
    past.cancel(request);
  }

  CompletableFuture<Void> stepOver(int threadNumber, SteppingGranularity granularity) {
    return step(Debugger::stepOver, threadNumber, granularity);
  }

  CompletableFuture<Void> stepInto(int threadNumber, SteppingGranularity granularity) {
    return step(Debugger::stepInto, threadNumber, granularity);
  }

  CompletableFuture<Void> stepOut(int threadNumber, SteppingGranularity granularity) {
    return step(Debugger::stepOut, threadNumber, granularity);
  }

  CompletableFuture<Void> stepBack(SteppingGranularity granularity) {
    return granularity == SteppingGranularity.INSTRUCTION ? past.frameBack() : past.stepBack();
  }

  CompletableFuture<Void> reverseContinue() {
    return past.reverseContinue();
  }

  /** Lets the program run until a thread comes to a line that has a statement. */
  CompletableFuture<Void> runTo(int threadNumber, int line) {
    if (past.past()) {
      return Refusals.answer(PastView.unchangeable());
    }
    wishes.expect(StopWishes.Step.LINE);
    int thread = DebugSession.thread(threadNumber);
    return go(debugger -> debugger.runTo(thread, line));
  }

  private CompletableFuture<Void> step(
      BiConsumer<Debugger, Integer> step, int threadNumber, SteppingGranularity granularity) {
    boolean frame = granularity == SteppingGranularity.INSTRUCTION;
    if (past.past()) {
      return frame ? past.frameOn() : past.stepOn();
    }
    if (ended()) {
      leaveEnd();
      return CompletableFuture.completedFuture(null);
    }
    wishes.expect(StopWishes.Step.STATEMENT);
    if (frame) {
      wishes.expect(StopWishes.Pause.FRAME);
      session.program().run().holdAfterFrame();
      return go(Debugger::resume);
    }
    int thread = DebugSession.thread(threadNumber);
    return go(debugger -> step.accept(debugger, thread));
  }

  /**
   * To where the next move begins, or to the end of the one that is under way.
   *
   * @param back to where the last move began instead
   */
  CompletableFuture<Void> stepToMove(int threadNumber, boolean back) {
    if (back || past.past()) {
      Moves moves = session.program().moves();
      return back ? past.moveBack(moves) : past.moveOn(moves);
    }
    if (ended()) {
      leaveEnd();
      return CompletableFuture.completedFuture(null);
    }
    wishes.expect(StopWishes.Step.MOVE);
    int thread = DebugSession.thread(threadNumber);
    return go(debugger -> debugger.stepToCall(thread, Moves.FUNCTIONS));
  }

  /** Something after which the program goes on, unless the debugger refuses it. */
  private CompletableFuture<Void> go(Consumer<Debugger> how) {
    session.stopped();
    return session
        .ask(
            debugger -> {
              how.accept(debugger);
              return true;
            })
        .thenAccept(done -> session.goOn());
  }

  CompletableFuture<Void> pause() {
    if (session.view().isPresent()) {
      return Refusals.answer(text("stoppedAlready"));
    }
    return session
        .ask(
            debugger -> {
              debugger.pause();
              return true;
            })
        .thenAccept(done -> {});
  }
}
