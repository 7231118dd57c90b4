package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.editors.dap.DebugClient.refusal;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.eclipse.lsp4j.debug.BreakpointEventArguments;
import org.eclipse.lsp4j.debug.ContinuedEventArguments;
import org.eclipse.lsp4j.debug.DisconnectArguments;
import org.eclipse.lsp4j.debug.LoadedSourcesArguments;
import org.eclipse.lsp4j.debug.PauseArguments;
import org.eclipse.lsp4j.debug.RestartArguments;
import org.eclipse.lsp4j.debug.SetExceptionBreakpointsArguments;
import org.eclipse.lsp4j.debug.StepBackArguments;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.Pace;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.SteerableClock;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.editors.dap.run.AttachableRobot;
import org.pendant.language.source.Source;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ProgramState;

class AttachTest {
  private static final String WORK =
      """
      n = 0
      while True:
        n = n + 1
        sleep(0.05)
      end
      """;

  @TempDir private Path folder;

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final FrameLoop loop =
      FrameLoop.start(controller, new SteerableClock(new Pace.Times(20)));
  private final AttachableRobot robot = new AttachableRobot(controller, controller::programSource);

  @AfterEach
  void end() {
    loop.close();
  }

  private DebugClient client() throws Exception {
    Path file = folder.resolve("work.script");
    Files.writeString(file, WORK);
    return DebugClient.connect(file, Optional.of(robot));
  }

  /** Others start the program. */
  private void start() {
    start(WORK);
  }

  private void start(String text) {
    Source source = Source.of(folder.resolve("work.script").toString(), text);
    var program = controller.load(source).program().orElseThrow();
    var _ = controller.submit(new ProgramCommand.StartProgram(program)).join();
  }

  private static void attach(DebugClient client) throws Exception {
    client.initialize();
    client.server().attach(Map.of()).join();
    client.next(DebugClient.Ready.class);
  }

  @Test
  void looksIntoAProgramThatRunsAlready() throws Exception {
    try (DebugClient client = client()) {
      start();
      attach(client);
      assertTrue(client.breakpoints(4)[0].isVerified());
      client.configured();
      assertEquals("breakpoint", client.stop().getReason());
      assertEquals(4, client.line());
      int before = Integer.parseInt(client.evaluate("n", "watch"));
      client.resume();
      client.stop();
      assertEquals(before + 1, Integer.parseInt(client.evaluate("n", "watch")));
      client.stepOver();
      client.stop();
      assertEquals(3, client.line());
      client.server().stepBack(new StepBackArguments()).join();
      client.stop();
      assertEquals(4, client.line());
    }
  }

  @Test
  void breakpointsThatWereSetBeforeStopAProgramThatOthersStart() throws Exception {
    try (DebugClient client = client()) {
      attach(client);
      assertFalse(client.breakpoints(3)[0].isVerified());
      client.configured();
      start();
      assertTrue(client.next(BreakpointEventArguments.class).getBreakpoint().isVerified());
      client.stop();
      assertEquals(3, client.line());
      assertEquals(
          "work.script",
          client
              .server()
              .loadedSources(new LoadedSourcesArguments())
              .join()
              .getSources()[0]
              .getName());
    }
  }

  @Test
  void aHeldProgramGoesOnWhenTheEditorLeaves() throws Exception {
    try (DebugClient client = client()) {
      start();
      attach(client);
      client.configured();
      client.server().pause(new PauseArguments()).join();
      client.stop();
      client.server().disconnect(new DisconnectArguments()).join();
    }
    long frame = controller.state().frame();
    var feed = controller.feed().follow();
    while (controller.state().frame() < frame + 50) {
      feed.take();
    }
    assertEquals(ProgramState.RUNNING, controller.state().program().state());
    assertFalse(controller.state().debug().held());
  }

  @Test
  void whatOthersHaveSetInTheDebuggerIsLeftToThem() throws Exception {
    start();
    ask(debugger -> debugger.set(Breakpoint.at(3).when("False")));
    ask(debugger -> debugger.stopOnErrors(true));
    try (DebugClient client = client()) {
      attach(client);
      var _ = client.breakpoints(4);
      SetExceptionBreakpointsArguments none = new SetExceptionBreakpointsArguments();
      none.setFilters(new String[] {});
      var _ = client.server().setExceptionBreakpoints(none).join();
      client.configured();
      client.stop();
      client.server().disconnect(new DisconnectArguments()).join();
    }
    ask(
        debugger -> {
          assertEquals(
              List.of(3),
              debugger.breakpoints().stream().map(each -> each.breakpoint().line()).toList());
          assertTrue(debugger.stopsOnErrors());
        });
  }

  @Test
  void anEditorIsToldThatOthersHaveLetTheProgramGoOn() throws Exception {
    try (DebugClient client = client()) {
      start();
      attach(client);
      client.configured();
      client.server().pause(new PauseArguments()).join();
      client.stop();
      ask(Debugger::resume);
      client.next(ContinuedEventArguments.class);
      assertEquals(
          "the program is not stopped", refusal(client.server().stepBack(new StepBackArguments())));
    }
  }

  private void ask(Consumer<Debugger> question) {
    CompletableFuture<Boolean> done = new CompletableFuture<>();
    var _ =
        controller.submit(
            new DebugCommand.Debug(
                debugger -> {
                  try {
                    question.accept(debugger);
                    done.complete(true);
                  } catch (RuntimeException | AssertionError e) {
                    done.completeExceptionally(e);
                  }
                }));
    assertTrue(done.join());
  }

  @Test
  void aSafetyStopIsToldAndThatOthersHaveEndedIt() throws Exception {
    try (DebugClient client = client()) {
      attach(client);
      SetExceptionBreakpointsArguments wanted = new SetExceptionBreakpointsArguments();
      wanted.setFilters(new String[] {"safetyStop"});
      var _ = client.server().setExceptionBreakpoints(wanted).join();
      client.configured();
      start("protective_stop()\nsleep(1)\n");
      StoppedEventArguments stop = client.stop();
      assertEquals("exception", stop.getReason());
      assertEquals("A safety function has stopped the arm", stop.getDescription());
      var _ = controller.submit(new SafetyCommand.UnlockProtectiveStop(true)).join();
      client.next(ContinuedEventArguments.class);
    }
  }

  @Test
  void oneEditorAtATimeIsAttached() throws Exception {
    try (DebugClient first = client()) {
      attach(first);
      try (DebugClient second = client()) {
        second.initialize();
        assertEquals(
            "another editor is attached to this robot", refusal(second.server().attach(Map.of())));
      }
      assertEquals(
          "only programs that were launched are restarted",
          refusal(first.server().restart(new RestartArguments())));
    }
    try (DebugClient third = client()) {
      attach(third);
    }
  }

  @Test
  void withoutARobotThereIsNothingToAttachTo() throws Exception {
    try (DebugClient client = DebugClient.of(folder, WORK)) {
      client.initialize();
      assertTrue(
          refusal(client.server().attach(Map.of())).startsWith("there is no robot to attach to"));
    }
  }
}
