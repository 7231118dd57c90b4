package org.pendant.editors.dap;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.eclipse.lsp4j.debug.BreakpointLocationsArguments;
import org.eclipse.lsp4j.debug.BreakpointLocationsResponse;
import org.eclipse.lsp4j.debug.CancelArguments;
import org.eclipse.lsp4j.debug.Capabilities;
import org.eclipse.lsp4j.debug.CompletionsArguments;
import org.eclipse.lsp4j.debug.CompletionsResponse;
import org.eclipse.lsp4j.debug.ConfigurationDoneArguments;
import org.eclipse.lsp4j.debug.ContinueArguments;
import org.eclipse.lsp4j.debug.ContinueResponse;
import org.eclipse.lsp4j.debug.DataBreakpointInfoArguments;
import org.eclipse.lsp4j.debug.DataBreakpointInfoResponse;
import org.eclipse.lsp4j.debug.DisconnectArguments;
import org.eclipse.lsp4j.debug.EvaluateArguments;
import org.eclipse.lsp4j.debug.EvaluateResponse;
import org.eclipse.lsp4j.debug.ExceptionInfoArguments;
import org.eclipse.lsp4j.debug.ExceptionInfoResponse;
import org.eclipse.lsp4j.debug.GotoArguments;
import org.eclipse.lsp4j.debug.GotoTargetsArguments;
import org.eclipse.lsp4j.debug.GotoTargetsResponse;
import org.eclipse.lsp4j.debug.InitializeRequestArguments;
import org.eclipse.lsp4j.debug.LoadedSourcesArguments;
import org.eclipse.lsp4j.debug.LoadedSourcesResponse;
import org.eclipse.lsp4j.debug.NextArguments;
import org.eclipse.lsp4j.debug.PauseArguments;
import org.eclipse.lsp4j.debug.RestartArguments;
import org.eclipse.lsp4j.debug.ReverseContinueArguments;
import org.eclipse.lsp4j.debug.ScopesArguments;
import org.eclipse.lsp4j.debug.ScopesResponse;
import org.eclipse.lsp4j.debug.SetBreakpointsArguments;
import org.eclipse.lsp4j.debug.SetBreakpointsResponse;
import org.eclipse.lsp4j.debug.SetDataBreakpointsArguments;
import org.eclipse.lsp4j.debug.SetDataBreakpointsResponse;
import org.eclipse.lsp4j.debug.SetExceptionBreakpointsArguments;
import org.eclipse.lsp4j.debug.SetExceptionBreakpointsResponse;
import org.eclipse.lsp4j.debug.SetExpressionArguments;
import org.eclipse.lsp4j.debug.SetExpressionResponse;
import org.eclipse.lsp4j.debug.SetFunctionBreakpointsArguments;
import org.eclipse.lsp4j.debug.SetFunctionBreakpointsResponse;
import org.eclipse.lsp4j.debug.SetVariableArguments;
import org.eclipse.lsp4j.debug.SetVariableResponse;
import org.eclipse.lsp4j.debug.SourceArguments;
import org.eclipse.lsp4j.debug.SourceResponse;
import org.eclipse.lsp4j.debug.StackTraceArguments;
import org.eclipse.lsp4j.debug.StackTraceResponse;
import org.eclipse.lsp4j.debug.StepBackArguments;
import org.eclipse.lsp4j.debug.StepInArguments;
import org.eclipse.lsp4j.debug.StepOutArguments;
import org.eclipse.lsp4j.debug.TerminateArguments;
import org.eclipse.lsp4j.debug.TerminateThreadsArguments;
import org.eclipse.lsp4j.debug.ThreadsResponse;
import org.eclipse.lsp4j.debug.VariablesArguments;
import org.eclipse.lsp4j.debug.VariablesResponse;
import org.eclipse.lsp4j.debug.services.IDebugProtocolClient;
import org.eclipse.lsp4j.debug.services.IDebugProtocolServer;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.editors.dap.run.AttachableRobot;
import org.pendant.editors.dap.run.DebugTargets;
import org.pendant.script.function.Builtins;

/** Debug adapter: hands each request of a client to what answers it, in the session's turns. */
final class DebugAdapter implements IDebugProtocolServer, AutoCloseable {
  private final SessionThread turns;
  private final DebugSession session;
  private final ProgressEvents progress;
  private final StopKinds stops;
  private final Launching launching;
  private final Attaching attaching;
  private final ExecutionRequests execution;
  private final StackRequests inspection;
  private final ValueRequests values;
  private final ThreadRequests threads;
  private final SourceRequests sources;
  private final MomentRequests moments;
  private final MoveRequests moves;
  private final LiveRobotRequests robot;
  private final CompletionRequests completions;
  private final Runnable left;

  /**
   * An adapter for one client.
   *
   * @param robot that the client may attach to
   * @param left is run when the client has said that it leaves
   */
  DebugAdapter(
      DebugTargets targets,
      Optional<AttachableRobot> robot,
      SessionThread turns,
      Supplier<IDebugProtocolClient> client,
      Runnable left) {
    this.turns = turns;
    this.left = left;
    Builtins<ControlBox> builtins = StandardBuiltins.create();
    StopWishes wishes = new StopWishes();
    session = new DebugSession(turns, client);
    progress = new ProgressEvents(session);
    BreakpointTable table = new BreakpointTable();
    BreakpointRequests lines = new BreakpointRequests(session, table, builtins);
    DataBreakpoints data = new DataBreakpoints(session, table);
    stops =
        new StopKinds(
            lines,
            new FunctionBreakpoints(session, table, lines, builtins),
            data,
            new ExceptionFilters(session));
    launching = new Launching(session, targets, builtins, stops, wishes, progress);
    attaching = new Attaching(session, robot, builtins, stops, wishes);
    execution = new ExecutionRequests(session, wishes, new PastRequests(session, table, progress));
    inspection = new StackRequests(session);
    values = new ValueRequests(session, data);
    threads = new ThreadRequests(session);
    sources = new SourceRequests(session, execution);
    moments = new MomentRequests(session, execution);
    moves = new MoveRequests(session, execution);
    this.robot = new LiveRobotRequests(session, execution);
    completions = new CompletionRequests(session, builtins);
  }

  /** For what is answered at once. */
  private <T> CompletableFuture<T> now(Supplier<T> answer) {
    return turns.request(() -> CompletableFuture.completedFuture(answer.get()));
  }

  // --- beginning and end

  @Override
  public CompletableFuture<Capabilities> initialize(InitializeRequestArguments told) {
    return now(
        () -> {
          session.talkTo(
              ClientForm.of(told), Boolean.TRUE.equals(told.getSupportsVariablePaging()));
          return AdapterCapabilities.all(session.form());
        });
  }

  @Override
  public CompletableFuture<Void> launch(Map<String, Object> told) {
    return turns.request(() -> launching.launch(told));
  }

  @Override
  public CompletableFuture<Void> attach(Map<String, Object> told) {
    return turns.request(attaching::attach);
  }

  @Override
  public CompletableFuture<Void> configurationDone(ConfigurationDoneArguments told) {
    return turns.request(launching::configurationDone);
  }

  @Override
  @SuppressWarnings("unchecked") // what the client sends here is an object
  public CompletableFuture<Void> restart(RestartArguments told) {
    return turns.request(
        () ->
            launching.restart(
                told != null && told.getArguments() instanceof Map<?, ?> again
                    ? Optional.of((Map<String, Object>) again)
                    : Optional.empty()));
  }

  @Override
  public CompletableFuture<Void> terminate(TerminateArguments told) {
    return turns.request(launching::terminate);
  }

  @Override
  public CompletableFuture<Void> disconnect(DisconnectArguments told) {
    return turns.request(
        () -> {
          launching.end();
          turns.execute(left);
          return CompletableFuture.completedFuture(null);
        });
  }

  /** The client has gone. */
  @Override
  public void close() {
    CompletableFuture<Boolean> ended = new CompletableFuture<>();
    turns.execute(
        () -> {
          launching.end();
          ended.complete(true);
        });
    ended.join();
    turns.close();
  }

  // --- breakpoints

  @Override
  public CompletableFuture<SetBreakpointsResponse> setBreakpoints(SetBreakpointsArguments wanted) {
    return turns.request(() -> stops.lines().set(wanted));
  }

  @Override
  public CompletableFuture<BreakpointLocationsResponse> breakpointLocations(
      BreakpointLocationsArguments asked) {
    return now(() -> stops.lines().locations(asked));
  }

  @Override
  public CompletableFuture<SetExceptionBreakpointsResponse> setExceptionBreakpoints(
      SetExceptionBreakpointsArguments wanted) {
    return now(() -> stops.failures().set(wanted));
  }

  @Override
  public CompletableFuture<SetFunctionBreakpointsResponse> setFunctionBreakpoints(
      SetFunctionBreakpointsArguments wanted) {
    return turns.request(() -> stops.functions().set(wanted));
  }

  @Override
  public CompletableFuture<DataBreakpointInfoResponse> dataBreakpointInfo(
      DataBreakpointInfoArguments asked) {
    return turns.request(() -> stops.data().info(asked));
  }

  @Override
  public CompletableFuture<SetDataBreakpointsResponse> setDataBreakpoints(
      SetDataBreakpointsArguments wanted) {
    return now(() -> stops.data().set(wanted));
  }

  // --- going on and stopping

  @Override
  public CompletableFuture<ContinueResponse> continue_(ContinueArguments told) {
    return turns.request(execution::resume);
  }

  @Override
  public CompletableFuture<Void> next(NextArguments told) {
    return turns.request(() -> execution.stepOver(told.getThreadId(), told.getGranularity()));
  }

  @Override
  public CompletableFuture<Void> stepIn(StepInArguments told) {
    return turns.request(() -> execution.stepInto(told.getThreadId(), told.getGranularity()));
  }

  @Override
  public CompletableFuture<Void> stepOut(StepOutArguments told) {
    return turns.request(() -> execution.stepOut(told.getThreadId(), told.getGranularity()));
  }

  @Override
  public CompletableFuture<Void> stepBack(StepBackArguments told) {
    return turns.request(() -> execution.stepBack(told.getGranularity()));
  }

  @Override
  public CompletableFuture<Void> reverseContinue(ReverseContinueArguments told) {
    return turns.request(execution::reverseContinue);
  }

  @Override
  public CompletableFuture<Void> cancel(CancelArguments asked) {
    return now(
        () -> {
          Optional.ofNullable(asked.getRequestId()).ifPresent(execution::cancel);
          Optional.ofNullable(asked.getProgressId()).ifPresent(progress::cancel);
          return null;
        });
  }

  @Override
  public CompletableFuture<GotoTargetsResponse> gotoTargets(GotoTargetsArguments asked) {
    return now(() -> sources.targets(asked));
  }

  @Override
  public CompletableFuture<Void> goto_(GotoArguments asked) {
    return turns.request(() -> sources.goTo(asked));
  }

  @Override
  public CompletableFuture<Void> terminateThreads(TerminateThreadsArguments asked) {
    return turns.request(() -> threads.end(asked));
  }

  @Override
  public CompletableFuture<Void> pause(PauseArguments told) {
    return turns.request(execution::pause);
  }

  // --- looking

  @Override
  public CompletableFuture<ThreadsResponse> threads() {
    return turns.request(inspection::threads);
  }

  @Override
  public CompletableFuture<StackTraceResponse> stackTrace(StackTraceArguments asked) {
    return now(() -> inspection.stackTrace(asked));
  }

  @Override
  public CompletableFuture<ScopesResponse> scopes(ScopesArguments asked) {
    return turns.request(() -> inspection.scopes(asked.getFrameId()));
  }

  @Override
  public CompletableFuture<VariablesResponse> variables(VariablesArguments asked) {
    return turns.request(() -> values.variables(asked));
  }

  @Override
  public CompletableFuture<SetVariableResponse> setVariable(SetVariableArguments asked) {
    return turns.request(() -> values.setVariable(asked));
  }

  @Override
  public CompletableFuture<EvaluateResponse> evaluate(EvaluateArguments asked) {
    return turns.request(() -> values.evaluate(asked));
  }

  @Override
  public CompletableFuture<SetExpressionResponse> setExpression(SetExpressionArguments asked) {
    return turns.request(() -> values.setExpression(asked));
  }

  @Override
  public CompletableFuture<ExceptionInfoResponse> exceptionInfo(ExceptionInfoArguments asked) {
    return now(threads::failure);
  }

  @Override
  public CompletableFuture<CompletionsResponse> completions(CompletionsArguments asked) {
    return now(() -> completions.complete(asked));
  }

  /** A message as the people at the client read it. */
  String shown(String message) {
    return session.form().shown(message);
  }

  /** What the protocol has no word for: other services of the same connection. */
  List<Object> beyondTheProtocol() {
    return List.of(moments, moves, robot);
  }

  // --- texts

  @Override
  public CompletableFuture<SourceResponse> source(SourceArguments asked) {
    return now(() -> sources.source(asked));
  }

  @Override
  public CompletableFuture<LoadedSourcesResponse> loadedSources(LoadedSourcesArguments asked) {
    return now(sources::loaded);
  }
}
