package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.LogEntry;
import org.pendant.language.signature.Type;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Effect;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;

/** What goes wrong while moves are looked for ahead is told, and the program continues. */
class MoveLookAheadFaultTest {
  private static final int MAX_FRAMES = 20_000;

  private int faults;

  @Test
  void faultWhileLookingAheadIsToldOnceAndTheProgramGoesOn() {
    Builtins<ControlBox> builtins = StandardBuiltins.create();
    builtins
        .declare("height")
        .manual("internals", "16.1")
        .doc("A height, which cannot be computed ahead.")
        .returns(Type.NUMBER)
        .effect(Effect.ASKS)
        .does(
            call -> {
              if (!call.program().getClass().getSimpleName().equals("Control")) {
                faults++;
                throw new IllegalStateException("broken");
              }
              return call.answer(0.4);
            });
    Controller controller = new Controller(ControllerOptions.headless(), builtins);
    List<String> reported = new ArrayList<>();
    Source text =
        Source.of(
            "test",
            """
            def prog():
              i = 0
              while i < 4:
                movel(p[0.4, -0.1 + i * 0.05, 0.4, 2.2214, -2.2214, 0], r=0.01)
                h = height()
                movel(p[0.45, -0.1 + i * 0.05, h, 2.2214, -2.2214, 0], r=0.01)
                i = i + 1
              end
            end
            """);
    CompletableFuture<Reply> started =
        controller.submit(
            new ProgramCommand.StartProgram(controller.load(text).program().orElseThrow()));
    for (int i = 0; i < MAX_FRAMES; i++) {
      controller.advance();
      controller.state().newEntries().stream().map(LogEntry::text).forEach(reported::add);
      if (i > 1 && controller.state().program().state() == ProgramState.STOPPED) {
        break;
      }
    }
    assertEquals(new Reply.Done(), started.join());
    assertInstanceOf(
        Ending.Finished.class,
        controller.state().program().ending().orElseThrow(),
        () -> "" + reported);
    assertTrue(faults > 1, "it looked ahead " + faults + " times");
    assertEquals(
        1,
        reported.stream().filter(line -> line.startsWith("internal error")).count(),
        () -> "" + reported);
  }
}
