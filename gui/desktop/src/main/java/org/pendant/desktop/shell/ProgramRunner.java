package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.EventQueue;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.desktop.debug.ProgramLaunch;
import org.pendant.desktop.debug.RunScript;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SessionMember;
import org.pendant.kit.background.Background;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.project.program.ControlScript;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.externalcontrol.Drivers;
import org.pendant.protocols.externalcontrol.NoScript;
import org.pendant.protocols.externalcontrol.ScriptRequest;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/**
 * Program runner: runs the current program, and lets the controller do things; refusals are told.
 */
final class ProgramRunner {
  private final RobotSession session;
  private final Programs programs;
  private final Consumer<String> tell;
  private final SourcePlace showSource;

  /** What was started last on each controller, by its name. */
  private final Map<String, Running> running = new HashMap<>();

  private BiConsumer<ProgramDocument, RunScript> beforeRun = (document, script) -> {};
  private Gate gate = (document, from, run) -> run.run();
  private Texts texts =
      (document, from) -> ProgramLaunch.of(RunScript.whole(document.script().source()));
  private Runnable stepOver = () -> {};
  private BiFunction<ProgramDocument, Integer, String> places =
      (document, line) -> text("line", line);
  private Runnable forgotten = () -> {};
  private final Drivers drivers = new Drivers(AllowedHosts.ANY, Optional.empty());
  private Optional<ScriptRequest> asked = Optional.empty();
  private boolean loading;

  /** What is about to start must not: its script came just before it was stopped. */
  private boolean stopped;

  /** A program and its text when it was started. */
  private record Running(ProgramDocument document, RunScript script) {
    Source source() {
      return script.source();
    }
  }

  /** A program and the controller that runs it. */
  record Assigned(SessionMember member, ProgramDocument document) {}

  /** What became of a text that is to run. */
  private record Compiled(RunScript script, LoadResult loadResult) {}

  /** Decides whether a program may start. */
  @FunctionalInterface
  interface Gate {
    /**
     * Runs {@code run} now or later, or tells why not.
     *
     * @param from key of the node that it starts at; 0 for its beginning
     */
    void pass(ProgramDocument document, long from, Runnable run);
  }

  /** Knows what a program is as a script. */
  @FunctionalInterface
  interface Texts {
    /**
     * What to run.
     *
     * @param from as for {@link Gate}
     */
    ProgramLaunch of(ProgramDocument document, long from);
  }

  ProgramRunner(
      RobotSession session, Programs programs, Consumer<String> tell, SourcePlace showSource) {
    this.session = session;
    this.programs = programs;
    this.tell = tell;
    this.showSource = showSource;
  }

  /** Has {@code action} follow each program that is about to start, secondary ones apart. */
  void beforeEachRun(BiConsumer<ProgramDocument, RunScript> action) {
    beforeRun = action;
  }

  /** Has programs pass {@code wanted} before they are compiled. */
  void setGate(Gate wanted) {
    gate = wanted;
  }

  /** Has {@code wanted} say what programs are as scripts. */
  void setTexts(Texts wanted) {
    texts = wanted;
  }

  /** Has {@code wanted} run a paused program to its next line. */
  void stepOverBy(Runnable wanted) {
    stepOver = wanted;
  }

  /** Calls lines of programs so in what is told. */
  void nameLinesBy(BiFunction<ProgramDocument, Integer, String> names) {
    places = names;
  }

  /** Whether a program is about to start: it is being compiled, or a driver is asked for a part. */
  boolean loading() {
    return loading;
  }

  /** Why nothing else can be started while {@link #loading}. */
  String whyLoading() {
    return asked
        .map(each -> text("isBeingAskedForTheScript", each.host().text()))
        .orElse(text("theProgramIsBeingCompiled"));
  }

  /** Whether a driver is being asked, which {@link #stop} ends. */
  boolean asking() {
    return asked.isPresent();
  }

  /** Stops the program, also one that is about to start and waits for a driver. */
  void stop() {
    if (asked.isPresent()) {
      asked.get().cancel();
      stopped = true;
    } else {
      send(new ProgramCommand.StopProgram());
    }
  }

  /** Resumes a paused program, or starts the current one as it stands. */
  void runOrResume() {
    if (session.state().debug().held()) {
      send(new DebugCommand.Debug(Debugger::resume));
      return;
    }
    if (session.state().program().state() == ProgramState.PAUSED) {
      tellRefusal(session.resume());
      return;
    }
    load(0, () -> {});
  }

  /** Starts the current program, a tree, at the node of a key. */
  void runFrom(long key) {
    load(key, () -> {});
  }

  /** An input asks for what {@link #runOrResume} does; nothing happens while a program runs. */
  void startByInput() {
    ProgramState state = session.state().program().state();
    if (state != ProgramState.RUNNING && !loading) {
      runOrResume();
    }
  }

  /** Runs a paused program to its next line; holds one that runs, or one that it starts. */
  void step() {
    switch (ProgramPhase.of(session.state())) {
      case STOPPED -> load(0, () -> send(new DebugCommand.Debug(Debugger::pause)));
      case RUNNING -> send(new DebugCommand.Debug(Debugger::pause));
      case PAUSED -> stepOver.run();
    }
  }

  /**
   * @param then follows the command that starts the program
   */
  private void load(long from, Runnable then) {
    ProgramDocument document = programs.current();
    Assigned assigned = new Assigned(session.shown(), document);
    gate.pass(document, from, () -> load(assigned, texts.of(document, from), then));
  }

  private void load(Assigned assigned, ProgramLaunch plan, Runnable then) {
    ProgramDocument document = assigned.document();
    loading = true;
    stopped = false;
    asked =
        plan.waitingNodes() == 0
            ? Optional.empty()
            : Optional.of(drivers.request(plan.installation(), plan.waitingNodes()).begin());
    Optional<ScriptRequest> request = asked;
    Background.run(
        () -> compiled(assigned.member(), plan, request),
        compiled -> {
          asked = Optional.empty();
          if (stopped) {
            loading = false;
            return;
          }
          start(assigned, compiled.script(), compiled.loadResult(), then);
        },
        failed -> {
          asked = Optional.empty();
          loading = false;
          tell.accept(text("cannotRun", document.name(), failed.getMessage()));
        });
  }

  /** Waits for the driver if there is one to wait for. */
  private static Compiled compiled(
      SessionMember member, ProgramLaunch plan, Optional<ScriptRequest> request)
      throws IOException {
    try {
      Optional<ControlScript> sent =
          request.isPresent() ? Optional.of(request.get().await()) : Optional.empty();
      RunScript script = plan.script().apply(sent);
      return new Compiled(script, member.robot().load(script.source()));
    } catch (NoScript e) {
      throw new IOException(e.getMessage(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  private void start(Assigned assigned, RunScript script, LoadResult loadResult, Runnable then) {
    loading = false;
    if (refused(assigned, script, loadResult)) {
      return;
    }
    starts(assigned, script, loadResult.program().orElseThrow());
    tellRefusal(session.run(assigned.member(), loadResult.program().orElseThrow()));
    then.run();
  }

  /** Whether a program does not compile, which is told. */
  private boolean refused(Assigned assigned, RunScript script, LoadResult loadResult) {
    Source source = script.source();
    Optional<Diagnostic> error =
        loadResult.diagnostics().stream().filter(Diagnostic::isError).findFirst();
    if (error.isEmpty()) {
      return false;
    }
    int start = error.get().range().start();
    int runLine = source.line(start);
    int line = script.lines().toShown(runLine);
    long count = loadResult.diagnostics().stream().filter(Diagnostic::isError).count();
    String message = Messages.shown(ByteText.decoded(error.get().message()));
    tell.accept(
        text(
            "cannotRunAt",
            assigned.document().name(),
            script.lines().origin(runLine).orElseGet(() -> places.apply(assigned.document(), line)),
            count > 1 ? text("andMoreErrors", message, count - 1) : message));
    programs.select(assigned.document());
    showSource.show(line, source.column(start));
    return true;
  }

  private void starts(Assigned assigned, RunScript script, Program program) {
    running.put(assigned.member().name(), new Running(assigned.document(), script));
    if (!program.secondary() && assigned.member().name().equals(session.shown().name())) {
      beforeRun.accept(assigned.document(), script);
    }
  }

  /** Starts programs in the same frame, unless one of them does not compile. */
  void runTogether(List<Assigned> all) {
    List<ProgramLaunch> plans = all.stream().map(each -> texts.of(each.document(), 0)).toList();
    for (int i = 0; i < plans.size(); i++) {
      if (plans.get(i).waitingNodes() > 0) {
        tell.accept(
            text(
                "asksADriverForItsScript",
                all.get(i).document().name(),
                all.get(i).member().name()));
        return;
      }
    }
    loading = true;
    Background.run(
        () -> {
          List<Compiled> compiled = new ArrayList<>();
          for (int i = 0; i < all.size(); i++) {
            compiled.add(compiled(all.get(i).member(), plans.get(i), Optional.empty()));
          }
          return compiled;
        },
        compiled -> startTogether(all, compiled),
        failed -> {
          loading = false;
          tell.accept(text("nothingRuns", failed.getMessage()));
        });
  }

  private void startTogether(List<Assigned> all, List<Compiled> compiled) {
    loading = false;
    for (int i = 0; i < all.size(); i++) {
      if (refused(all.get(i), compiled.get(i).script(), compiled.get(i).loadResult())) {
        return;
      }
    }
    List<Program> loaded =
        compiled.stream().map(each -> each.loadResult().program().orElseThrow()).toList();
    for (int i = 0; i < all.size(); i++) {
      starts(all.get(i), compiled.get(i).script(), loaded.get(i));
    }
    List<CompletableFuture<Reply>> replies = new ArrayList<>();
    session.between(
        () -> {
          for (int i = 0; i < all.size(); i++) {
            replies.add(session.run(all.get(i).member(), loaded.get(i)));
          }
        });
    replies.forEach(this::tellRefusal);
  }

  /** Another controller of the cell is shown: what runs there is what was started there. */
  void shown() {
    Running known = running.get(session.shown().name());
    if (known == null) {
      forgotten.run();
    } else {
      beforeRun.accept(known.document(), known.script());
    }
  }

  /** Has {@code action} follow when nothing is known of a program that was started. */
  void whenForgotten(Runnable action) {
    forgotten = action;
  }

  /** A program is about to be started by somebody else, for the user, as {@code script}. */
  void startsElsewhere(ProgramDocument document, RunScript script) {
    running.put(session.shown().name(), new Running(document, script));
    beforeRun.accept(document, script);
  }

  /** The controller is back in the run of a program that was started some time ago. */
  void backTo(ProgramDocument document, RunScript script) {
    Optional<Running> now = running();
    if (now.isEmpty() || !now.get().script().equals(script)) {
      startsElsewhere(document, script);
    }
  }

  /** Has the controller do something. */
  void send(Command command) {
    tellRefusal(session.submit(command));
  }

  private void tellRefusal(CompletableFuture<Reply> asked) {
    var _ =
        asked.thenAccept(
            reply -> {
              String what = reply instanceof Reply.Failed ? "failed" : "refused";
              reply
                  .complaint()
                  .ifPresent(why -> EventQueue.invokeLater(() -> tell.accept(text(what, why))));
            });
  }

  private Optional<Running> running() {
    return Optional.ofNullable(running.get(session.shown().name()));
  }

  /** The program that was started last. */
  Optional<ProgramDocument> program() {
    return running().map(Running::document);
  }

  /** The program that runs is none of the open ones. */
  void forget() {
    running.remove(session.shown().name());
  }

  /** The text of a line of the program that was started last; empty where there is none. */
  String line(int number) {
    return running()
        .map(Running::source)
        .filter(source -> number >= 1 && number <= source.lineCount())
        .map(source -> source.lineText(number))
        .orElse("");
  }
}
