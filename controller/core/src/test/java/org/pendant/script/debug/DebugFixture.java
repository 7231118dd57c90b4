package org.pendant.script.debug;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.message.LogEntry;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Machine;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ThreadSnapshot;

/** A control box with a debugger, driven frame by frame as the controller does. */
final class DebugFixture {
  private static final int MAX_FRAMES = 3000;
  private static final Builtins<ControlBox> BUILTINS = StandardBuiltins.create();

  final ControlBox box = new ControlBox(BoxSetup.headless("ur5e"));
  final Machine machine = new Machine(BUILTINS, box, 64_000_000);
  final List<String> logged = new ArrayList<>();
  final Debugger debugger = new Debugger(machine, logged::add);
  private final List<String> messages = new ArrayList<>();

  /** Frames that were completed. */
  int frames;

  private boolean inFrame;

  Program compile(String text) {
    LoadResult loadResult = ProgramLoader.load(Source.of("test", text), BUILTINS);
    return loadResult
        .program()
        .orElseThrow(
            () ->
                new AssertionError(
                    loadResult.diagnostics().stream().map(Diagnostic::message).toList()));
  }

  DebugFixture start(String text) {
    machine.start(compile(text));
    return this;
  }

  /** Continues with the frame, to its end or until it is held; whether it is over. */
  boolean advance() {
    if (!inFrame) {
      box.beginFrame();
    }
    inFrame = machine.advance();
    if (!inFrame) {
      box.motion().step();
      box.drive().step();
      frames++;
    }
    return !inFrame;
  }

  /** Completes some frames, none of which may be held. */
  DebugFixture advance(int count) {
    for (int i = 0; i < count; i++) {
      if (!advance()) {
        throw new AssertionError("held: " + debugger.state());
      }
    }
    return this;
  }

  /** Runs until the program is held or over. */
  DebugFixture go() {
    for (int i = 0; i < MAX_FRAMES; i++) {
      if (!advance() || machine.state() != ProgramState.RUNNING) {
        return this;
      }
    }
    throw new AssertionError("neither held nor over after " + MAX_FRAMES + " frames");
  }

  DebugFixture resume() {
    debugger.resume();
    return go();
  }

  DebugFixture over() {
    debugger.stepOver(stop().thread());
    return go();
  }

  DebugFixture into() {
    debugger.stepInto(stop().thread());
    return go();
  }

  DebugFixture out() {
    debugger.stepOut(stop().thread());
    return go();
  }

  /** Removes all breakpoints and runs to the end. */
  Ending finish() {
    debugger.removeBreakpoints();
    resume();
    return ending();
  }

  Ending ending() {
    return machine.ending().orElseThrow(() -> new AssertionError("still " + machine.state()));
  }

  DebugState.Stop stop() {
    return debugger
        .state()
        .stop()
        .orElseThrow(() -> new AssertionError("not held, ended with " + machine.ending()));
  }

  int line() {
    return stop().line();
  }

  /** The functions that the stopped thread is in, innermost first, with their lines. */
  List<String> stack() {
    return thread(stop().thread()).stack().stream()
        .map(level -> level.function() + ":" + level.line())
        .toList();
  }

  ThreadSnapshot thread(int id) {
    return debugger.threads().stream().filter(each -> each.id() == id).findAny().orElseThrow();
  }

  private int depth() {
    return thread(stop().thread()).stack().size();
  }

  /** The text of an expression where the program has stopped. */
  String value(String expression) {
    try {
      return debugger.evaluate(stop().thread(), depth(), expression).text();
    } catch (ScriptError e) {
      return "error: " + e.getMessage();
    }
  }

  /** Assigns where the program has stopped; answers the new text or the refusal. */
  String assign(String target, String expression) {
    try {
      return debugger.assign(stop().thread(), depth(), target, expression).text();
    } catch (ScriptError e) {
      return "error: " + e.getMessage();
    }
  }

  /** What the program has sent so far. */
  List<String> messages() {
    box.log().takeNew().entries().stream()
        .filter(entry -> entry.origin() == LogEntry.Origin.SCRIPT)
        .map(LogEntry::text)
        .forEach(messages::add);
    return messages;
  }

  static Optional<String> refusal(Runnable request) {
    try {
      request.run();
      return Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.of(e.getMessage());
    }
  }
}
