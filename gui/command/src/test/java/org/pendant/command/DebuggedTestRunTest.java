package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.editors.dap.run.DebugTarget;
import org.pendant.editors.dap.run.RobotRun;
import org.pendant.editors.dap.run.RunListener;
import org.pendant.editors.dap.run.RunResult;
import org.pendant.script.debug.Debugger;
import org.pendant.testing.run.DebuggedTest;
import org.pendant.text.Language;

/** Tests as the debug adapter runs them. */
final class DebuggedTestRunTest {
  private static final String TESTS =
      """
      def test_green():
        x = 1
        sleep(0.1)
        assert_equal(x, 1)
      end
      def test_red():
        assert_equal(1, 2)
      end
      """;

  @TempDir private Path folder;

  /** Keeps what a run tells. */
  private static final class Kept implements RunListener {
    private final CompletableFuture<RunResult> result = new CompletableFuture<>();
    private final CompletableFuture<Integer> heldLine = new CompletableFuture<>();

    @Override
    public void frame(ControllerState state) {
      state.debug().stop().ifPresent(stop -> heldLine.complete(stop.line()));
    }

    @Override
    public void safetyStop(ControllerState state) {
      failed(new AssertionError("safety stop"));
    }

    @Override
    public void wentOn() {
      failed(new AssertionError("nothing stopped"));
    }

    @Override
    public void note(String text) {
      assertEquals("test_green passed", text);
    }

    @Override
    public void over(RunResult told) {
      result.complete(told);
    }

    @Override
    public void failed(Throwable fault) {
      result.completeExceptionally(fault);
    }
  }

  private RobotRun start(String test, Kept kept, boolean held) throws Exception {
    return start(TESTS, test, kept, held);
  }

  private RobotRun start(String tests, String test, Kept kept, boolean held) throws Exception {
    Path file = Files.writeString(folder.resolve("a_test.script"), tests);
    DebugTarget target =
        new DebuggedPrograms().test(file.toString(), test, List.of(), Language.ENGLISH);
    DebuggedTest debugged = target.test().orElseThrow();
    RobotRun run = RobotRun.begin(debugged.controller(), target, kept, Runnable::run);
    assertEquals(Optional.empty(), run.start(debugged.program(), file.toString(), held).join());
    return run;
  }

  @Test
  void theOtherArmsOfACellGoOnWithTheTest() throws Exception {
    Files.writeString(
        folder.resolve("two.scene.json"),
        """
        {
          "arms": [
            {"name": "left"},
            {"name": "right", "base": [1, 0, 0, 0, 0, 3], "program": "raise.script"}
          ],
          "wires": [["right.digital_out[0]", "left.digital_in[0]"]]
        }
        """);
    Files.writeString(
        folder.resolve("raise.script"), "sleep(0.3)\nset_standard_digital_out(0, True)\n");
    String tests =
        """
        # @scene two.scene.json
        def test_green():
          waited = 0
          while not get_standard_digital_in(0):
            sync()
            waited = waited + 1
          end
          assert_true(waited > 100)
        end
        """;
    Kept kept = new Kept();
    try (RobotRun run = start(tests, "test_green", kept, true)) {
      assertEquals(3, kept.heldLine.join());
      run.ask(Debugger::threads).join();
      var _ = run.robot().submit(new DebugCommand.Debug(Debugger::resume));
      assertEquals(RunResult.DONE, kept.result.join().exitCode());
    }
  }

  @Test
  void aRedTestEndsWithWhatIsWrong() throws Exception {
    Kept kept = new Kept();
    try (RobotRun run = start("test_red", kept, false)) {
      RunResult result = kept.result.join();
      assertEquals(RunResult.PROGRAM_FAILED, result.exitCode());
      assertEquals("test_red is red: assert_equal: is 1, must be 2", result.reason().orElseThrow());
      assertFalse(run.robot().state().debug().held());
    }
  }

  @Test
  void aTestIsHeldBeforeItsFirstStatementAndEndsGreen() throws Exception {
    Kept kept = new Kept();
    try (RobotRun run = start("test_green", kept, true)) {
      assertEquals(2, kept.heldLine.join());
      var _ =
          run.ask(
              debugger -> {
                resume(debugger);
                return true;
              });
      assertEquals(RunResult.DONE, kept.result.join().exitCode());
    }
  }

  private static void resume(Debugger debugger) {
    debugger.resume();
  }
}
