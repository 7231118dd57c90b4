package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.project.program.ProgramTree;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramLabel;
import org.pendant.script.vm.ProgramState;

/** A tree that runs on a controller with an ideal arm, by the script that is generated from it. */
final class TreeRun {
  private static final int MAX_FRAMES = 60_000;

  private final Controller controller;
  private final Program program;
  private final List<String> said = new ArrayList<>();
  private final List<Popup> popups = new ArrayList<>();
  private final double startS;

  /** Starts a program on a headless controller that answers popups itself. */
  TreeRun(ProgramTree tree) {
    this(tree, Installation.NONE, ControllerOptions.headless());
  }

  TreeRun(ProgramTree tree, Installation installation) {
    this(tree, installation, ControllerOptions.headless());
  }

  TreeRun(ProgramTree tree, Installation installation, ControllerOptions options) {
    controller = new Controller(options.withArm(ArmChoice.IDEAL).withStart(TestTrees.START));
    GeneratedScript script = ScriptGenerator.generate("test", tree, installation);
    LoadResult loadResult = controller.load(Source.of("test.script", script.text()));
    assertEquals(List.of(), TestTrees.unexpected(loadResult), script::text);
    startS = state().timeS();
    program = loadResult.program().orElseThrow();
    submit(new ProgramCommand.StartProgram(program));
  }

  /** Runs a tree to its end. */
  static TreeRun of(ProgramTree tree) {
    return new TreeRun(tree).finish();
  }

  static TreeRun of(ProgramTree tree, Installation installation) {
    return new TreeRun(tree, installation).finish();
  }

  void submit(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    advance(1);
    assertEquals(new Reply.Done(), reply.join());
  }

  void advance(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
      popups.addAll(state().newPopups());
      for (LogEntry entry : state().newEntries()) {
        if (entry.origin() == LogEntry.Origin.SCRIPT) {
          said.add(entry.text());
        }
      }
    }
  }

  TreeRun advanceS(double timeS) {
    advance((int) Math.round(timeS / 0.002));
    return this;
  }

  /** Continues until the program has said something. */
  TreeRun until(String text) {
    for (int i = 0; i < MAX_FRAMES && !said.contains(text); i++) {
      advance(1);
    }
    assertTrue(said.contains(text), () -> "said " + said);
    return this;
  }

  /** Continues until the program has ended as it should. */
  TreeRun finish() {
    for (int i = 0; i < MAX_FRAMES && state().program().state() != ProgramState.STOPPED; i++) {
      advance(1);
    }
    assertEquals(ProgramState.STOPPED, state().program().state(), () -> "said " + said);
    assertTrue(!state().program().failed(), () -> state().program().ending().toString());
    return this;
  }

  ControllerState state() {
    return controller.state();
  }

  boolean running() {
    return state().program().state() == ProgramState.RUNNING;
  }

  /** How long it has run, s. */
  double timeS() {
    return state().timeS() - startS;
  }

  /** What the program wrote to the log. */
  List<String> said() {
    return said;
  }

  List<Popup> popups() {
    return popups;
  }

  /** The labels of the script. */
  List<ProgramLabel> labels() {
    return program.labels();
  }

  /** A global variable as text. */
  String variable(String name) {
    return controller.globals().get(name).text();
  }

  boolean output(int number) {
    return (state().io().standardOut() >> number & 1) != 0;
  }

  /** Text of the language in a log line, which is bytes there. */
  static String bytes(String text) {
    return new String(text.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
  }
}
