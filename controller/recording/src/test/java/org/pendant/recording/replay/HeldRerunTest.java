package org.pendant.recording.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.ProgramState;

/** Runs that a debugger held and changed are repeated with all that it did. */
@Tag("slow")
final class HeldRerunTest {
  private static final String PROGRAM =
      """
      def prog():
        thread blink():
          while True:
            set_standard_digital_out(0, not get_standard_digital_out(0))
            sleep(0.05)
          end
        end
        h = run blink()
        q = get_target_joint_positions()
        i = 0
        while i < 60:
          q[0] = q[0] + 0.02 * random()
          movej(q, a=3, v=1)
          q[1] = q[1] + 0.05
          movej(q, a=3, v=1)
          i = i + 1
        end
        kill h
      end
      """;

  private final Play play = new Play(ControllerOptions.headless());
  private final Controller controller = play.controller();

  /** What was published last in each frame. */
  private final Map<Long, List<Object>> frames = new HashMap<>();

  /** What was published each time, also while the program was held. */
  private final List<List<Object>> all = new ArrayList<>();

  private void advance() {
    controller.advance();
    ControllerState state = controller.state();
    frames.put(state.frame(), Play.facts(state));
    all.add(Play.facts(state));
  }

  private boolean held() {
    return controller.state().debug().held();
  }

  private void ask(Consumer<Debugger> request) {
    var _ = controller.submit(new DebugCommand.Debug(request));
  }

  private static void assign(Debugger debugger, String target, String value) {
    try {
      debugger.assign(Debugger.MAIN, Debugger.OUTERMOST, target, value);
    } catch (ScriptError e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  private static void evaluate(Debugger debugger, String expression) {
    try {
      assertTrue(
          debugger.evaluate(Debugger.MAIN, Debugger.OUTERMOST, expression).text().length() > 0);
    } catch (ScriptError e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /** Steps, changes variables, draws random numbers in watches and idles while held. */
  private void debug(SplittableRandom random) {
    int thread = controller.state().debug().stop().orElseThrow().thread();
    for (int idle = random.nextInt(40); idle > 0; idle--) {
      advance();
    }
    switch (random.nextInt(6)) {
      case 0 -> ask(debugger -> assign(debugger, "q[0]", "q[0] - 0.05"));
      case 1 -> ask(debugger -> evaluate(debugger, "random()"));
      case 2 -> ask(debugger -> evaluate(debugger, "q[0] + i"));
      case 3 -> ask(debugger -> assign(debugger, "nothing", "1"));
      default -> {
        // continues as it is
      }
    }
    if (random.nextBoolean()) {
      advance();
    }
    ask(
        switch (random.nextInt(4)) {
          case 0 -> debugger -> debugger.stepOver(thread);
          case 1 -> debugger -> debugger.stepInto(thread);
          case 2 -> debugger -> debugger.runTo(Debugger.MAIN, 14);
          default -> Debugger::resume;
        });
  }

  private void run(long last) {
    SplittableRandom random = new SplittableRandom(17);
    for (int line : new int[] {4, 12, 13, 15}) {
      ask(debugger -> debugger.set(Breakpoint.at(line).when("random() > 0.3")));
    }
    var _ = controller.submit(new ProgramCommand.StartProgram(play.program(PROGRAM)));
    int stops = 0;
    while (controller.state().frame() < last || held()) {
      if (held()) {
        stops++;
        debug(random);
      } else if (random.nextInt(200) == 0) {
        ask(Debugger::pause);
      }
      advance();
    }
    assertTrue(stops > 50, stops + " stops");
    assertEquals(ProgramState.RUNNING, controller.state().program().state());
  }

  @Test
  void aRerunMakesTheSameStopsAndChanges() throws RerunRefused {
    run(1500);
    List<List<Object>> again = new ArrayList<>();
    Controller fresh = new Controller(play.options);
    Rerun.to(1500, play.journal.run())
        .run(Controllers.of(fresh), () -> again.add(Play.facts(fresh.state())));
    assertEquals(all, again);
  }

  @Test
  void anyFrameCanBeReachedBetweenTheStops() throws RerunRefused {
    run(1500);
    SplittableRandom random = new SplittableRandom(23);
    for (int i = 0; i < 20; i++) {
      long frame = random.nextLong(1, 1500);
      ControllerState state = play.again(frame).controller().state();
      assertFalse(state.debug().held());
      assertEquals(frames.get(frame), Play.facts(state), "frame " + frame);
    }
  }

  @Test
  void aFrameThatIsStillHeldIsHeldInTheBranchToo() throws RerunRefused {
    ask(debugger -> debugger.set(Breakpoint.at(13)));
    var _ = controller.submit(new ProgramCommand.StartProgram(play.program(PROGRAM)));
    while (!held()) {
      advance();
    }
    ask(debugger -> assign(debugger, "i", "2"));
    advance();
    advance();
    ControllerState now = controller.state();
    Journal branch = play.again(now);
    ControllerState there = branch.controller().state();
    assertTrue(there.debug().held());
    assertEquals(
        now.debug().stop().orElseThrow().line(), there.debug().stop().orElseThrow().line());
    assertEquals("2", branch.controller().globals().get("i").text());
    var _ = branch.controller().submit(new DebugCommand.Debug(Debugger::resume));
    branch.controller().advance();
    assertFalse(branch.controller().state().debug().held());
  }

  @Test
  void looksAreNotKept() {
    var _ = controller.submit(new ProgramCommand.StartProgram(play.program(PROGRAM)));
    advance();
    int kept = play.journal.run().size();
    ask(debugger -> evaluate(debugger, "q[0] + i"));
    ask(Debugger::threads);
    ask(debugger -> debugger.variables(Debugger.MAIN, Debugger.OUTERMOST));
    advance();
    assertEquals(kept, play.journal.run().size());
  }
}
