package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.debug.LoadedSourceEventArguments;
import org.eclipse.lsp4j.debug.LoadedSourceEventArgumentsReason;
import org.pendant.controller.box.ControlBox;
import org.pendant.editors.dap.run.AttachableRobot;
import org.pendant.editors.dap.run.AttachedRobot;
import org.pendant.editors.dap.run.RunResult;
import org.pendant.language.source.Source;
import org.pendant.script.debug.Debugger;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.script.vm.ThreadSnapshot;

/** Attaching: looks into a robot on which others start programs. */
final class Attaching {
  private final DebugSession session;
  private final Optional<AttachableRobot> robot;
  private final Builtins<ControlBox> builtins;
  private final StopKinds stops;
  private final StopWishes wishes;
  private Optional<AttachedRobot> attached = Optional.empty();

  /** What is said of the program that runs; read by the thread that follows the robot. */
  private volatile OutputEvents output;

  /**
   * Of a robot.
   *
   * @param robot empty where the adapter has none but those that it launches
   */
  Attaching(
      DebugSession session,
      Optional<AttachableRobot> robot,
      Builtins<ControlBox> builtins,
      StopKinds stops,
      StopWishes wishes) {
    this.session = session;
    this.robot = robot;
    this.builtins = builtins;
    this.stops = stops;
    this.wishes = wishes;
    output = new OutputEvents(line -> Optional.empty(), DebuggedText.unknown(ClientForm.STANDARD));
  }

  CompletableFuture<Void> attach() {
    if (robot.isEmpty()) {
      return Refusals.answer(text("noRobotToAttachTo"));
    }
    if (session.debuggee().isPresent()) {
      return Refusals.answer(text("hasRobotAlready"));
    }
    RunEvents events = new RunEvents(session, stops, wishes, () -> output);
    AttachedRobot following =
        AttachedRobot.begin(
            robot.get(),
            new AttachEvents(session, events, this::started, this::ended),
            session.thread());
    attached = Optional.of(following);
    debug(DebuggedText.unknown(session.form()), none(), following, events);
    stops.anotherDebugger();
    return look().thenAccept(done -> session.thread().execute(session.client()::initialized));
  }

  private void debug(
      DebuggedText text, Program program, AttachedRobot following, RunEvents events) {
    output = new OutputEvents(line -> Optional.empty(), text);
    session.debug(
        Optional.of(
            new Debuggee(
                new LaunchArguments("", Optional.empty(), List.of(), false, false, false),
                program,
                text,
                following,
                events)));
  }

  /** A program without statements stands for none. */
  private Program none() {
    return ProgramLoader.load(Source.of(text("noProgram"), "sync()\n"), builtins)
        .program()
        .orElseThrow();
  }

  /** Looks for a program that runs already. */
  private CompletableFuture<Boolean> look() {
    AttachedRobot following = attached.orElseThrow();
    return following
        .ask(Debugger::threads)
        .thenCompose(
            threads ->
                threads.isEmpty()
                    ? stops.launched()
                    : following.program().thenCompose(source -> begun(source, threads)));
  }

  /** At once: the program may have stopped already, which is told next. */
  private void started() {
    var _ = begun(attached.orElseThrow().startedText(), List.of());
  }

  /** Another program runs. */
  private CompletableFuture<Boolean> begun(Optional<Source> source, List<ThreadSnapshot> threads) {
    Optional<Program> program =
        source.flatMap(text -> ProgramLoader.load(text, builtins).program());
    Optional<Debuggee> before = session.debuggee();
    if (program.isEmpty() || before.isEmpty()) {
      return CompletableFuture.completedFuture(false);
    }
    if (!sameText(before.get(), source.get())) {
      DebuggedText text = new DebuggedText(session.form(), source.get(), file(source.get()));
      debug(text, program.get(), attached.orElseThrow(), before.get().events());
      LoadedSourceEventArguments told = new LoadedSourceEventArguments();
      told.setReason(LoadedSourceEventArgumentsReason.NEW);
      told.setSource(text.asSource());
      session.client().loadedSource(told);
    }
    session.tellThreads(
        threads.isEmpty()
            ? List.of(Debugger.MAIN)
            : threads.stream().map(ThreadSnapshot::id).toList());
    return stops.launched();
  }

  private static boolean sameText(Debuggee before, Source now) {
    Source text = before.text().source();
    return before.text().known()
        && text.name().equals(now.name())
        && text.text().equals(now.text());
  }

  private static Optional<Path> file(Source source) {
    return ClientForm.STANDARD.file(source.name()).filter(Files::isRegularFile);
  }

  private void ended(RunResult result) {
    if (attached.isEmpty() || session.debuggee().isEmpty()) {
      return;
    }
    output.of(result).ifPresent(session.client()::output);
    session.goOn();
    session.tellThreads(List.of());
  }
}
