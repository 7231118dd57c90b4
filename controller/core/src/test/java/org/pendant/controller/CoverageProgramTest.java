package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.coverage.CoverageSite;
import org.pendant.script.coverage.CoverageSite.Kind;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.script.vm.ProgramState;

/** What a program reaches is told after its run, which is the same as without coverage. */
final class CoverageProgramTest {
  private static final String PROGRAM =
      """
      def blended():
        ticks = 0
        thread tick():
          while True:
            ticks = ticks + 1
            i = 0
            while i < 3000 or i == 5000:
              i = i + 1
            end
            sync()
          end
        end
        run tick()
        movej([0, -1.6, -1.7, -1.4, 1.5708, 0], r=0.05)
        if get_standard_digital_in(0) and ticks > 0:
          movej([0.5, -1.6, -1.7, -1.4, 1.5708, 0])
        else:
          ticks = ticks + 100
          movej([0.3, -1.5, -1.7, -1.4, 1.5708, 0])
        end
        textmsg(ticks)
      end
      """;

  private final Controller controller = new Controller(ControllerOptions.headless());

  private static void start(Controller controller, LoadResult loaded) {
    var reply = controller.submit(new ProgramCommand.StartProgram(loaded.program().orElseThrow()));
    controller.advance();
    assertTrue(reply.isDone());
  }

  private LoadResult covered() {
    return ProgramLoader.loadCovered(Source.of("blended.script", PROGRAM), controller.builtins());
  }

  private static List<String> frames(Controller controller) {
    List<String> frames = new ArrayList<>();
    do {
      controller.advance();
      ControllerState state = controller.state();
      frames.add(state.program().line() + " " + state.arm().targetTcpInBase());
      state.newEntries().forEach(entry -> frames.add(entry.text()));
    } while (controller.state().program().state() != ProgramState.STOPPED);
    return frames;
  }

  @Test
  void everyFrameIsTheSameWithCoverage() {
    start(controller, covered());
    List<String> covered = frames(controller);
    Controller other = new Controller(ControllerOptions.headless());
    start(other, other.load(Source.of("blended.script", PROGRAM)));
    assertEquals(frames(other), covered);
    assertTrue(covered.size() > 500, "the program moves");
    assertEquals(List.of(16), missing(controller.coverage().orElseThrow()));
  }

  @Test
  void lookingAheadForMovesReachesNothing() {
    start(controller, covered());
    controller.runUntil(() -> controller.state().program().line() == 14, 1000);
    controller.runUntil(() -> false, 20);
    assertEquals(List.of(15, 16, 18, 19, 21), missing(controller.coverage().orElseThrow()));
  }

  /** The lines whose statements were not reached. */
  private static List<Integer> missing(Coverage coverage) {
    return coverage.map().sites().stream()
        .filter(site -> site.kind() == Kind.STATEMENT && !coverage.reached(site))
        .map(CoverageSite::line)
        .toList();
  }
}
