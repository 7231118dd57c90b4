package org.pendant.desktop.debug;

import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.editor.Execution;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.kit.settings.Settings;
import org.pendant.language.source.Source;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ProgramState;

/** A program, a controller that the test drives, and the presenter between them. */
final class DebugFixture {
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final PreviewWorkbench workbench = new PreviewWorkbench();
  private final ProgramDocument document;
  private final Programs programs;
  private final DebugPresenter debug;
  private String shown = "";

  DebugFixture(String... lines) {
    document = ProgramDocument.untitled("test.script", String.join("\n", lines) + "\n");
    programs = new Programs(document);
    debug =
        new DebugPresenter(
            workbench, programs, new SessionLink(this::submit, Runnable::run), () -> shown);
  }

  /** Carries a command out at once, in a frame of its own. */
  private CompletableFuture<Reply> submit(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    controller.advance();
    return reply;
  }

  ProgramDocument document() {
    return document;
  }

  HoverValues hoverValues() {
    return new HoverValues(debug, () -> controller.state().variables());
  }

  DebugPresenter debug() {
    return debug;
  }

  /** Another controller of the cell is shown, of which {@code state} is the newest snapshot. */
  void show(String controller, ControllerState state) {
    shown = controller;
    debug.refresh(state);
  }

  /** Sets breakpoints in place of all others. */
  void breakAt(Integer... lines) {
    SortedSet<Integer> all = new TreeSet<>(List.of(lines));
    debug.breakpoints().linesChanged(document, all);
  }

  /** Starts the program and runs it until it is held or has ended. */
  void run() {
    debug.breakpoints().beforeRun(document);
    var _ =
        submit(
            new ProgramCommand.StartProgram(
                controller.load(document.source()).program().orElseThrow()));
    advance();
  }

  /** Starts a text that may be a part of the program, and runs it until it is held or has ended. */
  void run(RunScript script) {
    start(script);
    advance();
  }

  /** Starts a text that may be a part of the program. */
  void start(RunScript script) {
    debug.breakpoints().beforeRun(document, script);
    var _ =
        submit(
            new ProgramCommand.StartProgram(
                controller.load(script.source()).program().orElseThrow()));
  }

  /** Others start a program of their own, which runs until it is held or has ended. */
  void runStranger(String... lines) {
    debug.breakpoints().strangerStarted(Optional.empty());
    Source source = Source.of("stranger", String.join("\n", lines) + "\n");
    var _ =
        submit(new ProgramCommand.StartProgram(controller.load(source).program().orElseThrow()));
    advance();
  }

  /** Starts the program. */
  void start() {
    start(RunScript.whole(document.source()));
  }

  /** Resumes a program that the debugger has paused. */
  void resume() {
    ask(Debugger::resume);
  }

  /** Somebody asks the debugger. */
  void ask(Consumer<Debugger> request) {
    var _ = submit(new DebugCommand.Debug(request));
  }

  /** Pauses the program as an operator does. */
  void pause() {
    var _ = submit(new ProgramCommand.PauseProgram());
    refresh();
  }

  /** Runs the program until it is held or has ended. */
  void advance() {
    controller.runUntil(
        () ->
            controller.state().debug().held()
                || controller.state().program().state() == ProgramState.STOPPED,
        5000);
    refresh();
  }

  /** Lets frames go by. */
  void frames(int count) {
    for (int i = 0; i < count; i++) {
      controller.advance();
    }
    refresh();
  }

  private void refresh() {
    debug.refresh(controller.state());
  }

  /** Each row as {@code name = value}, indented by its level. */
  static List<String> rows(ValueTree tree) {
    return tree.rows().stream().map(DebugFixture::text).toList();
  }

  private static String text(ValueRow row) {
    return switch (row) {
      case ValueRow.Heading heading -> heading.title();
      case ValueRow.Value value ->
          " ".repeat(value.level())
              + value.name()
              + " = "
              + value.text()
              + (value.changed() ? " *" : "");
      case ValueRow.More more -> more.text();
      case ValueRow.Problem problem -> "! " + problem.text();
    };
  }

  /** The row of a value. */
  static ValueRow.Value row(ValueTree tree, String name) {
    return tree.rows().stream()
        .filter(row -> row instanceof ValueRow.Value value && value.name().equals(name))
        .map(ValueRow.Value.class::cast)
        .findFirst()
        .orElseThrow(() -> new AssertionError(name + " is not among " + rows(tree)));
  }

  List<String> told() {
    return workbench.told();
  }

  /** Where the program is. */
  Execution execution() {
    return debug.execution(controller.state());
  }

  /** What the program reads. */
  String text() {
    return document.text();
  }

  /** Gives the program another text. */
  void edit(String text) {
    document.setText(text);
  }

  /** Closes the program; another one is in front then. */
  void close() {
    programs.close(document, ProgramDocument.untitled("other.script", ""));
  }

  /** Whether the program is in front. */
  boolean isInFront() {
    return programs.current() == document;
  }

  Settings settings() {
    return workbench.settings();
  }
}
