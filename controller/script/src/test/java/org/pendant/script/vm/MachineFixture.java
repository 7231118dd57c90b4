package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.Value;

/** A machine with a handful of built-ins of its own, driven frame by frame. */
final class MachineFixture {
  private static final long MEMORY_BYTES = 64_000_000;

  final List<String> messages = new ArrayList<>();
  final Builtins<FakeHost> builtins = new Builtins<>();
  final Machine machine;
  int frames;

  MachineFixture() {
    this(Translation.WHEN_HOT);
  }

  MachineFixture(Translation translation) {
    builtins
        .declare("textmsg")
        .manual("internals", "16.63")
        .doc("Sends a message.")
        .needs("s1", Type.ANY)
        .takes("s2", Type.ANY, Value.of(""))
        .does(
            call -> {
              messages.add(call.value(0).text() + call.value(1).text());
              return call.answer();
            });
    builtins
        .declare("sync")
        .manual("internals", "16.62")
        .doc("Waits for the next frame.")
        .physicalTime()
        .does(call -> waitUntil(call.frame() + 1));
    builtins
        .declare("frames")
        .manual("internals", "16.54")
        .doc("Waits for some frames.")
        .needs("n", Unit.NONE)
        .physicalTime()
        .does(call -> waitUntil(call.frame() + call.integer(0)));
    builtins
        .declare("interpreter_mode")
        .manual("interpreter", "13.2")
        .doc("Enters interpreter mode.")
        .takes("clearQueueOnEnter", Type.BOOL, Value.of(true))
        .takes("clearOnEnd", Type.BOOL, Value.of(true))
        .physicalTime()
        .does(call -> call.program().enterInterpreter(call.bool(0), call.bool(1)));
    builtins
        .declare("end_interpreter")
        .manual("interpreter", "13.3")
        .doc("Leaves interpreter mode.")
        .does(
            call -> {
              call.program().endInterpreter();
              return call.answer();
            });
    builtins
        .declare("clear_interpreter")
        .manual("interpreter", "13.4")
        .doc("Forgets interpreted statements.")
        .does(
            call -> {
              call.program().clearInterpreter();
              return call.answer();
            });
    machine = new Machine(builtins, new FakeHost(), MEMORY_BYTES, translation);
  }

  private static Wait waitUntil(long wakeFrame) {
    return frame -> frame >= wakeFrame ? Optional.of(NoneValue.NONE) : Optional.empty();
  }

  /** Compiles the lines as one program; fails the test when they do not compile. */
  Program compile(String... lines) {
    return compiled(ProgramLoader.load(Source.of("test", String.join("\n", lines)), builtins));
  }

  /** As {@link #compile}, for coverage. */
  Program compileCovered(String... lines) {
    return compiled(
        ProgramLoader.loadCovered(Source.of("test", String.join("\n", lines)), builtins));
  }

  private static Program compiled(LoadResult loadResult) {
    return loadResult
        .program()
        .orElseThrow(
            () ->
                new AssertionError(
                    loadResult.diagnostics().stream().map(Diagnostic::message).toList()));
  }

  MachineFixture start(String... lines) {
    machine.start(compile(lines));
    return this;
  }

  MachineFixture advance(int count) {
    for (int i = 0; i < count; i++) {
      machine.advance();
      frames++;
    }
    return this;
  }

  /** Runs to the program's end, for at most 1000 frames. */
  Ending finish() {
    for (int i = 0; i < 1000 && machine.state() == ProgramState.RUNNING; i++) {
      machine.advance();
      frames++;
    }
    return machine.ending().orElseThrow();
  }

  /** Runs the lines to their end and answers what they sent. */
  List<String> run(String... lines) {
    start(lines);
    Ending ending = finish();
    if (ending instanceof Ending.Failed failed) {
      throw new AssertionError(failed.failure().toString());
    }
    return messages;
  }

  /** Runs the lines, which must fail. */
  ScriptFailure fail(String... lines) {
    start(lines);
    if (finish() instanceof Ending.Failed failed) {
      return failed.failure();
    }
    throw new AssertionError("ended with " + machine.ending());
  }

  /** Submits an interpreted line and answers its id, or the reason of the refusal. */
  String submit(String line) {
    return switch (machine.interpreter().submit(line)) {
      case Interpreter.Response.Acknowledged reply -> "ack " + reply.id();
      case Interpreter.Response.Discarded reply -> "discard " + reply.reason();
    };
  }
}
