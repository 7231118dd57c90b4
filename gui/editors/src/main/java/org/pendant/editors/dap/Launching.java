package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.eclipse.lsp4j.debug.OutputEventArgumentsCategory;
import org.pendant.controller.Controller;
import org.pendant.controller.box.ControlBox;
import org.pendant.editors.dap.run.DebugTarget;
import org.pendant.editors.dap.run.DebugTargets;
import org.pendant.editors.dap.run.RobotRun;
import org.pendant.editors.dap.run.TargetRefusal;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.script.debug.Debugger;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.testing.run.DebuggedTest;
import org.pendant.text.Language;

/** Launching: brings a program to its robot, and both to their end. */
final class Launching {
  private final DebugSession session;
  private final DebugTargets targets;
  private final Builtins<ControlBox> builtins;
  private final StopKinds stops;
  private final StopWishes wishes;
  private final ProgressEvents progress;
  private Optional<RobotRun> launched = Optional.empty();
  private boolean configured;
  private boolean started;
  private boolean launching;

  /** Counts what ends a program, or keeps one that is being read from beginning. */
  private int ends;

  /** A program that was read. */
  private record Read(DebugTarget target, LoadResult result) {}

  Launching(
      DebugSession session,
      DebugTargets targets,
      Builtins<ControlBox> builtins,
      StopKinds stops,
      StopWishes wishes,
      ProgressEvents progress) {
    this.progress = progress;
    this.session = session;
    this.targets = targets;
    this.builtins = builtins;
    this.stops = stops;
    this.wishes = wishes;
  }

  /** Reads a program and switches a robot on; it starts when the client has set its breakpoints. */
  CompletableFuture<Void> launch(Map<String, Object> told) {
    if (launching || session.debuggee().isPresent()) {
      return Refusals.answer(text("launchedAlready"));
    }
    return load(LaunchArguments.of(told))
        .thenCompose(
            loaded -> {
              // the client sets its breakpoints when it hears of this, and can be told where they
              // are
              session.thread().execute(session.client()::initialized);
              return startWhenConfigured();
            });
  }

  private CompletableFuture<Void> load(LaunchArguments arguments) {
    launching = true;
    int before = ends;
    return progress
        .of(
            text("reading", arguments.program()),
            false,
            CompletableFuture.supplyAsync(
                () -> read(arguments), task -> Thread.ofVirtual().name("launch").start(task)))
        .whenCompleteAsync((read, fault) -> launching = false, session.thread())
        .thenAccept(
            read -> {
              if (before != ends) {
                read.target().outside().run();
                throw Refusals.of(text("endedBeforeBegun", arguments.program()));
              }
              begin(arguments, read);
            });
  }

  private Read read(LaunchArguments arguments) {
    Language language = session.form().language().language();
    try {
      DebugTarget target =
          arguments.test().isPresent()
              ? targets.test(
                  arguments.program(), arguments.test().get(), arguments.options(), language)
              : targets.target(arguments.program(), arguments.options(), language);
      if (target.test().isPresent()) {
        Program test = target.test().get().program();
        return new Read(target, new LoadResult(Optional.of(test), List.of()));
      }
      return new Read(
          target,
          target
              .source()
              .map(source -> ProgramLoader.load(source, builtins))
              .orElseGet(() -> new LoadResult(Optional.empty(), List.of())));
    } catch (TargetRefusal e) {
      throw new CompletionException(e);
    }
  }

  private void begin(LaunchArguments arguments, Read read) {
    DebugTarget target = read.target();
    target.notes().forEach(note -> say(OutputEventArgumentsCategory.CONSOLE, note));
    target.problems().forEach(problem -> say(OutputEventArgumentsCategory.STDERR, problem));
    if (target.source().isEmpty()) {
      target.outside().run();
      throw Refusals.of(
          target.problems().stream().findFirst().orElse(text("treeCannotRun", target.file())));
    }
    DebuggedText text = new DebuggedText(session.form(), target);
    OutputEvents output = new OutputEvents(target.node(), text);
    read.result().diagnostics().forEach(each -> session.client().output(output.of(each)));
    if (read.result().program().isEmpty()) {
      target.outside().run();
      throw Refusals.of(mistakes(target, read.result().diagnostics()));
    }
    var program = read.result().program().get();
    if (program.secondary()) {
      target.outside().run();
      throw Refusals.of(text("secondaryProgram", target.file()));
    }
    RunEvents events = new RunEvents(session, stops, wishes, () -> output);
    RobotRun run =
        RobotRun.begin(
            target
                .test()
                .map(DebuggedTest::controller)
                .orElseGet(() -> new Controller(target.options(), builtins)),
            target,
            events,
            session.thread());
    session.debug(Optional.of(new Debuggee(arguments, program, text, run, events)));
    launched = Optional.of(run);
    stops.anotherDebugger();
    var _ = stops.launched();
  }

  private static String mistakes(DebugTarget target, List<Diagnostic> diagnostics) {
    var source = target.source().orElseThrow();
    List<Diagnostic> errors = diagnostics.stream().filter(Diagnostic::isError).toList();
    Diagnostic first = errors.getFirst();
    int at = Math.min(first.range().start(), source.text().length());
    String message = ByteText.decoded(first.message());
    return source.name()
        + ":"
        + source.line(at)
        + ":"
        + source.column(at)
        + ": "
        + (errors.size() == 1
            ? text("error", message)
            : text("errorAndMore", message, errors.size() - 1));
  }

  private void say(String category, String words) {
    session.client().output(OutputEvents.output(category, session.form().shown(words)));
  }

  /** The client has set its breakpoints. */
  CompletableFuture<Void> configurationDone() {
    configured = true;
    return startWhenConfigured();
  }

  private CompletableFuture<Void> startWhenConfigured() {
    if (!configured || started || launched.isEmpty()) {
      return CompletableFuture.completedFuture(null);
    }
    started = true;
    Debuggee debuggee = session.program();
    boolean held = debuggee.arguments().stopOnEntry() && !debuggee.arguments().noDebug();
    if (held) {
      wishes.expect(StopWishes.Pause.ENTRY);
    }
    session.tellThreads(List.of(Debugger.MAIN));
    String file = debuggee.arguments().program();
    return launched
        .get()
        .start(debuggee.program(), file, held)
        .thenAccept(
            refusal ->
                refusal.ifPresent(
                    why -> {
                      throw Refusals.of(file + ": " + ByteText.decoded(why));
                    }));
  }

  /** Begins anew, with the text and the arguments as they are now. */
  CompletableFuture<Void> restart(Optional<Map<String, Object>> told) {
    if (launching) {
      return Refusals.answer(text("launching"));
    }
    if (session.debuggee().isPresent() && launched.isEmpty()) {
      return Refusals.answer(text("notRestartable"));
    }
    LaunchArguments arguments = LaunchArguments.again(session.program().arguments(), told);
    end();
    return load(arguments)
        .thenCompose(
            loaded -> {
              configured = true;
              return startWhenConfigured();
            });
  }

  /** Ends the program; the arm comes to rest, and the client is told. */
  CompletableFuture<Void> terminate() {
    session
        .debuggee()
        .ifPresent(
            each -> {
              each.run().stop();
              // behind the answer to this request
              session.thread().execute(each.events()::endForGood);
            });
    return CompletableFuture.completedFuture(null);
  }

  /** Switches the robot off, whatever it does. */
  void end() {
    ends++;
    if (launched.isEmpty()) {
      stops.lines().uninstall();
    }
    Optional<Debuggee> debuggee = session.debuggee();
    session.debug(Optional.empty());
    started = false;
    launched = Optional.empty();
    debuggee.ifPresent(
        each -> {
          each.events().detach();
          each.run().close();
        });
  }
}
