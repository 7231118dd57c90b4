package org.pendant.editors.dap;

import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.eclipse.lsp4j.debug.ContinueResponse;
import org.pendant.script.debug.Debugger;

/** Requests that let a program go on, and that stop it. */
final class ExecutionRequests {
  private final DebugSession session;
  private final StopWishes wishes;

  ExecutionRequests(DebugSession session, StopWishes wishes) {
    this.session = session;
    this.wishes = wishes;
  }

  CompletableFuture<ContinueResponse> resume() {
    ContinueResponse response = new ContinueResponse();
    response.setAllThreadsContinued(true);
    if (session.program().run().atSafetyStop()) {
      session.goOn();
      session.program().run().leaveSafetyStop();
      return CompletableFuture.completedFuture(response);
    }
    return go(Debugger::resume).thenApply(done -> response);
  }

  CompletableFuture<Void> stepOver(int threadNumber) {
    return step(Debugger::stepOver, threadNumber);
  }

  CompletableFuture<Void> stepInto(int threadNumber) {
    return step(Debugger::stepInto, threadNumber);
  }

  CompletableFuture<Void> stepOut(int threadNumber) {
    return step(Debugger::stepOut, threadNumber);
  }

  /** Lets the program run until a thread comes to a line that has a statement. */
  CompletableFuture<Void> runTo(int threadNumber, int line) {
    wishes.expectLine(true);
    int thread = DebugSession.thread(threadNumber);
    return go(debugger -> debugger.runTo(thread, line));
  }

  private CompletableFuture<Void> step(BiConsumer<Debugger, Integer> step, int threadNumber) {
    wishes.expectLine(false);
    int thread = DebugSession.thread(threadNumber);
    return go(debugger -> step.accept(debugger, thread));
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
      return Refusals.answer("the program is stopped already");
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
