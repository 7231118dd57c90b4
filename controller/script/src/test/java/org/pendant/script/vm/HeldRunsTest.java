package org.pendant.script.vm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.language.source.Source;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.Debugger;
import org.pendant.script.value.ScriptError;

/** Being held changes nothing: a program does the same with and without stops. */
@Tag("slow")
class HeldRunsTest {
  private static final int PROGRAMS = 40 * Integer.getInteger("test.cases", 1);
  private static final int MAX_FRAMES = 60;
  private static final int MAX_STOPS = 400;

  /** All that a program shows to the outside. */
  private record Shown(List<String> messages, String ending, int frames, String globals) {
    static Shown of(MachineFixture fixture) {
      return new Shown(
          List.copyOf(fixture.messages),
          fixture.machine.ending().map(Ending::toString).orElse("still running"),
          fixture.frames,
          fixture.machine.globals().toString());
    }
  }

  /** A debugger that does something at random at every stop. */
  private static final class RestlessDebugger {
    private final Random random;
    private final Debugger debugger;
    private final List<String> messages;
    private final int lines;
    int stops;

    RestlessDebugger(Random random, MachineFixture fixture, int lines) {
      this.random = random;
      this.messages = fixture.messages;
      this.debugger = new Debugger(fixture.machine, _ -> {});
      this.lines = lines;
      someBreakpoints();
    }

    private void someBreakpoints() {
      debugger.removeBreakpoints();
      for (int i = random.nextInt(9); i > 0 && stops < MAX_STOPS; i--) {
        Breakpoint breakpoint = Breakpoint.at(1 + random.nextInt(lines));
        debugger.set(random.nextInt(3) > 0 ? breakpoint : breakpoint.when("g > h"));
      }
    }

    void betweenFrames() {
      if (random.nextInt(6) == 0) {
        someBreakpoints();
      }
      if (random.nextInt(3) > 0 && stops < MAX_STOPS) {
        debugger.pause();
      }
    }

    void whileHeld() {
      stops++;
      DebugState.Stop stop = debugger.state().stop().orElseThrow();
      int depth = debugger.state().threads().getFirst().stack().size();
      debugger.variables(0, depth);
      debugger.globals();
      int sent = messages.size();
      try {
        debugger.evaluate(0, depth, random.nextBoolean() ? "f1(g, [1, 2])" : "g + h * 2");
      } catch (ScriptError e) {
        // as good as any other outcome
      }
      // what the expression itself has sent
      messages.subList(sent, messages.size()).clear();
      if (random.nextInt(8) == 0) {
        someBreakpoints();
      }
      switch (stops < MAX_STOPS ? random.nextInt(9) : 8) {
        case 0, 4, 5, 6 -> debugger.stepInto(stop.thread());
        case 1 -> debugger.stepOver(stop.thread());
        case 2 -> debugger.stepOut(stop.thread());
        case 3 -> debugger.runTo(stop.thread(), 1 + random.nextInt(lines - 5));
        default -> debugger.resume();
      }
    }
  }

  private static Shown runFreely(String text, Translation translation) {
    MachineFixture fixture = new MachineFixture(translation);
    fixture.start(text);
    while (fixture.machine.state() == ProgramState.RUNNING && fixture.frames < MAX_FRAMES) {
      fixture.advance(1);
    }
    return Shown.of(fixture);
  }

  private static Shown runHeld(String text, Translation translation, Random random, int[] stops) {
    MachineFixture fixture = new MachineFixture(translation);
    int lines = Source.of("test", text).lineCount();
    RestlessDebugger restless = new RestlessDebugger(random, fixture, lines);
    fixture.start(text);
    while (fixture.machine.state() == ProgramState.RUNNING && fixture.frames < MAX_FRAMES) {
      restless.betweenFrames();
      while (fixture.machine.advance()) {
        assertTrue(fixture.machine.advance(), "held until it is let go");
        restless.whileHeld();
      }
      fixture.frames++;
    }
    stops[0] += restless.stops;
    return Shown.of(fixture);
  }

  @ParameterizedTest
  @EnumSource
  void randomProgramsDoTheSameWithAndWithoutStops(Translation translation) {
    int[] stops = new int[1];
    int compared = 0;
    for (int seed = 0; seed < PROGRAMS; seed++) {
      String text = new RandomScript(new Random(seed)).text();
      if (!new TranslationRuns(text, List.of()).valid()) {
        continue;
      }
      compared++;
      Shown expected = runFreely(text, translation);
      assertEquals(expected, runHeld(text, translation, new Random(seed), stops), "seed " + seed);
    }
    assertTrue(compared > PROGRAMS / 3, compared + " programs compared");
    assertTrue(stops[0] > 5 * compared, stops[0] + " stops");
  }

  @Test
  void translatedFunctionsStopAtABreakpointThatIsSetLater() {
    MachineFixture fixture = new MachineFixture(Translation.ALWAYS);
    Debugger debugger = new Debugger(fixture.machine, _ -> {});
    fixture.start(
        """
        def prog():
          def work(n):
            local i = 0
            while i < n:
              i = i + 1
            end
            return i
          end
          while True:
            last = work(100000)
          end
        end
        """);
    fixture.advance(3);
    debugger.set(Breakpoint.at(7));
    while (!fixture.machine.advance()) {
      assertTrue(fixture.frames++ < 100);
    }
    assertEquals(7, debugger.state().stop().orElseThrow().line());
    assertEquals("100000", debugger.variables(0, 2).getLast().text());
    debugger.removeBreakpoints();
    debugger.resume();
    fixture.advance(20);
    assertEquals("100000", fixture.machine.globals().get("last").text());
  }

  @Test
  void functionsAreTranslatedAgainWhenTheirTrapsAreGone() {
    MachineFixture fixture = new MachineFixture(Translation.ALWAYS);
    Debugger debugger = new Debugger(fixture.machine, _ -> {});
    debugger.set(Breakpoint.at(4));
    fixture.start("def prog():", "  i = 0", "  while True:", "    i = i + 1", "  end", "end");
    assertTrue(fixture.machine.advance());
    ProgramRun run = fixture.machine.run().orElseThrow();
    ScriptFunction original = run.program().tables().functions().getFirst();
    assertEquals(original, run.main().functions[0].original());
    assertTrue(run.main().functions[0] != original, "a trapped form");
    debugger.removeBreakpoints();
    debugger.resume();
    fixture.advance(2);
    assertEquals(original, run.main().functions[0]);
  }

  @Test
  void aCriticalSectionStaysOneWhileItIsSteppedThrough() {
    MachineFixture fixture = new MachineFixture();
    Debugger debugger = new Debugger(fixture.machine, _ -> {});
    debugger.set(Breakpoint.at(8));
    fixture.start(
        """
        def prog():
          thread other():
            textmsg("other")
          end
          h = run other()
          enter_critical
          i = 0
          while i < 150000:
            i = i + 1
          end
          textmsg("critical done")
          exit_critical
          join h
        end
        """);
    for (int i = 0; i < 50; i++) {
      assertTrue(fixture.machine.advance());
      debugger.stepOver(0);
    }
    debugger.removeBreakpoints();
    if (fixture.machine.advance()) {
      debugger.resume();
    }
    fixture.finish();
    assertEquals(List.of("critical done", "other"), fixture.messages);
  }

  @Test
  void aThreadGoesOnInTheSameFrameEvenIfItsBudgetIsJustUsedUp() {
    String text =
        """
        def prog():
          i = 0
          while i < %d:
            i = i + 1
          end
          textmsg(i)
        end
        """
            .formatted(Slices.PRIMARY.computing(1) / Cost.turn(2) + 1);
    assertEquals(1, runFreely(text, Translation.WHEN_HOT).frames());
    MachineFixture fixture = new MachineFixture();
    Debugger debugger = new Debugger(fixture.machine, _ -> {});
    debugger.set(Breakpoint.at(6));
    fixture.start(text);
    assertTrue(fixture.machine.advance());
    assertEquals(0, fixture.machine.run().orElseThrow().main().budget);
    debugger.resume();
    fixture.machine.advance();
    assertEquals(ProgramState.STOPPED, fixture.machine.state());
  }
}
