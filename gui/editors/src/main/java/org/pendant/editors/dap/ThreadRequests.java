package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.debug.ExceptionBreakMode;
import org.eclipse.lsp4j.debug.ExceptionDetails;
import org.eclipse.lsp4j.debug.ExceptionInfoResponse;
import org.eclipse.lsp4j.debug.InvalidatedAreas;
import org.eclipse.lsp4j.debug.TerminateThreadsArguments;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.editors.dap.look.LiveView;
import org.pendant.editors.dap.look.PastView;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.PauseReason;
import org.pendant.script.vm.ScriptFailure;

/** Requests about the end of threads: those that are to end, and those that failed. */
final class ThreadRequests {
  private final DebugSession session;

  ThreadRequests(DebugSession session) {
    this.session = session;
  }

  /** Ends threads of a stopped program, and those that they have started. */
  CompletableFuture<Void> end(TerminateThreadsArguments asked) {
    if (!(session.stopped() instanceof LiveView live)) {
      return Refusals.answer(PastView.unchangeable());
    }
    int[] numbers = Objects.requireNonNullElse(asked.getThreadIds(), new int[0]);
    List<Integer> threads = Arrays.stream(numbers).mapToObj(DebugSession::thread).toList();
    return session
        .ask(
            debugger -> {
              threads.forEach(debugger::kill);
              return debugger.threads();
            })
        .thenAccept(
            left ->
                session.change(
                    new LiveView(live.run(), live.state(), left), InvalidatedAreas.THREADS));
  }

  ExceptionInfoResponse failure() {
    ControllerState state = session.stopped().state();
    ExceptionInfoResponse response = new ExceptionInfoResponse();
    response.setBreakMode(ExceptionBreakMode.UNHANDLED);
    ExceptionDetails details = new ExceptionDetails();
    response.setDetails(details);
    if (state.debug().stop().isPresent()
        && state.debug().stop().get().reason() instanceof PauseReason.Failed(var failure)) {
      response.setExceptionId(failure.code());
      response.setDescription(session.form().shown(ByteText.decoded(failure.message())));
      details.setMessage(session.form().shown(ByteText.decoded(failure.message())));
      details.setTypeName(failure.code());
      details.setStackTrace(calls(failure));
      return response;
    }
    SafetyStop stop = state.safety().stop().orElseThrow(() -> Refusals.of(text("noFailure")));
    response.setExceptionId(stop.codeText());
    response.setDescription(session.form().shown(stop.message()));
    details.setMessage(session.form().shown(stop.message()));
    details.setTypeName(stop.codeText());
    return response;
  }

  private String calls(ScriptFailure failure) {
    StringBuilder calls = new StringBuilder();
    failure.stack().stream()
        .limit(OutputEvents.MAX_CALLS)
        .forEach(
            each ->
                calls
                    .append(session.form().shown(text("call", each.function(), each.line())))
                    .append('\n'));
    return calls.toString();
  }
}
