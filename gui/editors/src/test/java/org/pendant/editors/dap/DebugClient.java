package org.pendant.editors.dap;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import org.eclipse.lsp4j.debug.Breakpoint;
import org.eclipse.lsp4j.debug.BreakpointEventArguments;
import org.eclipse.lsp4j.debug.Capabilities;
import org.eclipse.lsp4j.debug.ConfigurationDoneArguments;
import org.eclipse.lsp4j.debug.ContinueArguments;
import org.eclipse.lsp4j.debug.ContinuedEventArguments;
import org.eclipse.lsp4j.debug.EvaluateArguments;
import org.eclipse.lsp4j.debug.ExitedEventArguments;
import org.eclipse.lsp4j.debug.InitializeRequestArguments;
import org.eclipse.lsp4j.debug.InvalidatedEventArguments;
import org.eclipse.lsp4j.debug.NextArguments;
import org.eclipse.lsp4j.debug.OutputEventArguments;
import org.eclipse.lsp4j.debug.ProgressEndEventArguments;
import org.eclipse.lsp4j.debug.ProgressStartEventArguments;
import org.eclipse.lsp4j.debug.Scope;
import org.eclipse.lsp4j.debug.ScopesArguments;
import org.eclipse.lsp4j.debug.SetBreakpointsArguments;
import org.eclipse.lsp4j.debug.Source;
import org.eclipse.lsp4j.debug.SourceBreakpoint;
import org.eclipse.lsp4j.debug.StackFrame;
import org.eclipse.lsp4j.debug.StackTraceArguments;
import org.eclipse.lsp4j.debug.StepInArguments;
import org.eclipse.lsp4j.debug.StepOutArguments;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.eclipse.lsp4j.debug.TerminatedEventArguments;
import org.eclipse.lsp4j.debug.ThreadEventArguments;
import org.eclipse.lsp4j.debug.Variable;
import org.eclipse.lsp4j.debug.VariablesArguments;
import org.eclipse.lsp4j.debug.services.IDebugProtocolClient;
import org.eclipse.lsp4j.debug.services.IDebugProtocolServer;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.jsonrpc.debug.DebugLauncher;
import org.eclipse.lsp4j.jsonrpc.services.JsonRequest;
import org.pendant.editors.dap.run.AttachableRobot;
import org.pendant.editors.wire.BytePipe;

/** A client for tests, connected to a debug adapter of its own by streams. */
final class DebugClient implements IDebugProtocolClient, AutoCloseable {
  private final BlockingQueue<Object> events = new LinkedBlockingQueue<>();
  private final List<OutputEventArguments> output = new CopyOnWriteArrayList<>();
  private final List<Throwable> faults = new CopyOnWriteArrayList<>();
  private final List<String> threads = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Boolean> served = new CompletableFuture<>();
  private final BytePipe toServer = new BytePipe();
  private final Path program;
  private String locale;
  private Server server;

  private DebugClient(Path program) {
    this.program = program;
  }

  /** The adapter with what the protocol has no word for. */
  interface Server extends IDebugProtocolServer {
    @JsonRequest("pendant/moments")
    CompletableFuture<JsonObject> moments(Map<String, Object> asked);

    @JsonRequest("pendant/robot")
    CompletableFuture<JsonObject> robot(Map<String, Object> asked);

    @JsonRequest("pendant/goToTime")
    CompletableFuture<Void> goToTime(Map<String, Object> asked);

    @JsonRequest("pendant/setSignal")
    CompletableFuture<Void> setSignal(Map<String, Object> asked);

    @JsonRequest("pendant/stepToMove")
    CompletableFuture<Void> stepToMove(Map<String, Object> asked);

    @JsonRequest("pendant/goToMoment")
    CompletableFuture<Void> goToMoment(Map<String, Object> asked);
  }

  /** Asks for a step to where the next move begins or the one under way ends. */
  void stepToMove() {
    await(server.stepToMove(Map.of("threadId", 1)));
  }

  /** What a client is told first: that it may set its breakpoints. */
  record Ready() {}

  /** A client that will debug a program with a text, which it writes into a folder. */
  static DebugClient of(Path folder, String text) throws IOException {
    Path program = folder.resolve("program.script");
    Files.writeString(program, text);
    return connect(program);
  }

  /** A client that will debug the file {@code program}; it has said nothing yet. */
  static DebugClient connect(Path program) throws IOException {
    return connect(program, Optional.empty());
  }

  /** As the other one, with a robot to attach to. */
  static DebugClient connect(Path program, Optional<AttachableRobot> robot) throws IOException {
    DebugClient client = new DebugClient(program);
    BytePipe toClient = new BytePipe();
    Thread.ofPlatform()
        .daemon()
        .start(
            () -> {
              try {
                DebugAdapterConnection.serve(
                    new FilesOnDisk(),
                    robot,
                    client.toServer.input(),
                    toClient.output(),
                    client.faults::add,
                    complaint -> client.faults.add(new IOException(complaint)));
                toClient.output().close();
                client.served.complete(true);
              } catch (Throwable e) {
                client.served.completeExceptionally(e);
              }
            });
    var launcher =
        new DebugLauncher.Builder<Server>()
            .setLocalService(client)
            .setRemoteInterface(Server.class)
            .setInput(toClient.input())
            .setOutput(client.toServer.output())
            .create();
    var _ = launcher.startListening();
    client.server = launcher.getRemoteProxy();
    return client;
  }

  Server server() {
    return server;
  }

  static <T> T await(CompletableFuture<T> answer) {
    return answer.join();
  }

  /** The message of a request that is refused. */
  static String refusal(CompletableFuture<?> answer) throws InterruptedException {
    try {
      throw new AssertionError("answered " + answer.get());
    } catch (ExecutionException | CompletionException e) {
      return e.getCause() instanceof ResponseErrorException refused
          ? refused.getResponseError().getMessage()
          : String.valueOf(e.getCause());
    }
  }

  /** Names its language; to be called first. */
  DebugClient speaking(String locale) {
    this.locale = locale;
    return this;
  }

  Capabilities initialize() {
    InitializeRequestArguments told = new InitializeRequestArguments();
    told.setLocale(locale);
    told.setAdapterID("pendant");
    told.setSupportsVariablePaging(true);
    return await(server.initialize(told));
  }

  /** Launches the program with further arguments, and waits until breakpoints can be set. */
  void launch(Map<String, Object> further) throws InterruptedException {
    initialize();
    Map<String, Object> arguments = new HashMap<>(further);
    arguments.put("program", program.toString());
    await(server.launch(arguments));
    next(Ready.class);
  }

  void launch() throws InterruptedException {
    launch(Map.of());
  }

  void configured() {
    await(server.configurationDone(new ConfigurationDoneArguments()));
  }

  Source source() {
    Source source = new Source();
    source.setPath(program.toString());
    return source;
  }

  Breakpoint[] breakpoints(int... lines) {
    return breakpoints(
        Arrays.stream(lines).mapToObj(DebugClient::at).toArray(SourceBreakpoint[]::new));
  }

  static SourceBreakpoint at(int line) {
    SourceBreakpoint at = new SourceBreakpoint();
    at.setLine(line);
    return at;
  }

  Breakpoint[] breakpoints(SourceBreakpoint... wanted) {
    SetBreakpointsArguments arguments = new SetBreakpointsArguments();
    arguments.setSource(source());
    arguments.setBreakpoints(wanted);
    return await(server.setBreakpoints(arguments)).getBreakpoints();
  }

  /** The next event of a kind; what comes before it is forgotten. */
  <T> T next(Class<T> kind) throws InterruptedException {
    while (true) {
      Object event = events.take();
      if (kind.isInstance(event)) {
        return kind.cast(event);
      }
      if (event instanceof TerminatedEventArguments) {
        throw new AssertionError("ended, expected " + kind.getSimpleName() + "; said " + said());
      }
    }
  }

  StoppedEventArguments stop() throws InterruptedException {
    return next(StoppedEventArguments.class);
  }

  /** Waits for the end; the exit code. */
  int end() throws InterruptedException {
    int code = next(ExitedEventArguments.class).getExitCode();
    next(TerminatedEventArguments.class);
    return code;
  }

  void resume() {
    var _ = await(server.continue_(new ContinueArguments()));
  }

  void stepOver() {
    NextArguments arguments = new NextArguments();
    arguments.setThreadId(1);
    await(server.next(arguments));
  }

  void stepInto() {
    StepInArguments arguments = new StepInArguments();
    arguments.setThreadId(1);
    await(server.stepIn(arguments));
  }

  void stepOut() {
    StepOutArguments arguments = new StepOutArguments();
    arguments.setThreadId(1);
    await(server.stepOut(arguments));
  }

  List<StackFrame> stack() {
    StackTraceArguments arguments = new StackTraceArguments();
    arguments.setThreadId(1);
    return List.of(await(server.stackTrace(arguments)).getStackFrames());
  }

  StackFrame top() {
    return stack().getFirst();
  }

  int line() {
    return top().getLine();
  }

  Map<String, Scope> scopes() {
    return scopes(top().getId());
  }

  Map<String, Scope> scopes(int frame) {
    ScopesArguments arguments = new ScopesArguments();
    arguments.setFrameId(frame);
    Map<String, Scope> scopes = new HashMap<>();
    for (Scope each : await(server.scopes(arguments)).getScopes()) {
      scopes.put(each.getName(), each);
    }
    return scopes;
  }

  List<Variable> variables(int reference) {
    VariablesArguments arguments = new VariablesArguments();
    arguments.setVariablesReference(reference);
    return List.of(await(server.variables(arguments)).getVariables());
  }

  /** Names and values of a scope of the innermost call. */
  Map<String, String> values(String scope) {
    Map<String, String> values = new HashMap<>();
    variables(scopes().get(scope).getVariablesReference())
        .forEach(each -> values.put(each.getName(), each.getValue()));
    return values;
  }

  String evaluate(String expression, String context) {
    return await(server.evaluate(evaluation(expression, context))).getResult();
  }

  EvaluateArguments evaluation(String expression, String context) {
    EvaluateArguments arguments = new EvaluateArguments();
    arguments.setExpression(expression);
    arguments.setContext(context);
    arguments.setFrameId(top().getId());
    return arguments;
  }

  /** What was said on a channel. */
  String said(String category) {
    StringBuilder said = new StringBuilder();
    for (OutputEventArguments each : output) {
      if (each.getCategory().equals(category)) {
        said.append(each.getOutput());
      }
    }
    return said.toString();
  }

  String said() {
    return said("console") + said("stdout") + said("stderr");
  }

  List<OutputEventArguments> output() {
    return new ArrayList<>(output);
  }

  /** Threads that were told of, such as {@code 1 started}. */
  List<String> threads() {
    return List.copyOf(threads);
  }

  List<Throwable> faults() {
    return faults;
  }

  @Override
  public void initialized() {
    events.add(new Ready());
  }

  @Override
  public void stopped(StoppedEventArguments told) {
    events.add(told);
  }

  @Override
  public void continued(ContinuedEventArguments told) {
    events.add(told);
  }

  @Override
  public void exited(ExitedEventArguments told) {
    events.add(told);
  }

  @Override
  public void terminated(TerminatedEventArguments told) {
    events.add(told);
  }

  @Override
  public void thread(ThreadEventArguments told) {
    threads.add(told.getThreadId() + " " + told.getReason());
  }

  @Override
  public void output(OutputEventArguments told) {
    output.add(told);
  }

  @Override
  public void breakpoint(BreakpointEventArguments told) {
    events.add(told);
  }

  @Override
  public void invalidated(InvalidatedEventArguments told) {
    events.add(told);
  }

  @Override
  public void progressStart(ProgressStartEventArguments told) {
    events.add(told);
  }

  @Override
  public void progressEnd(ProgressEndEventArguments told) {
    events.add(told);
  }

  /** Leaves without a word, and waits until the adapter has noticed. */
  @Override
  public void close() throws IOException {
    toServer.output().close();
    served.join();
    if (!faults.isEmpty()) {
      throw new AssertionError("faults in the adapter", faults.getFirst());
    }
  }
}
