package org.pendant.protocols.teachpendant;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StateStream;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.script.vm.ProgramState;

@Timeout(60)
class StartWatchTest {
  @TempDir Path folder;

  private RunningBox box(String startUp) {
    return new RunningBox(
        ControllerOptions.headless()
            .withInstallation(
                InstallationText.read("pendant installation 1\n" + startUp + "\n").installation()),
        RemoteControl.disabled());
  }

  /** A panel whose watch has seen a frame: an edge before it is none. */
  private RemotePendant panel(RunningBox box) throws InterruptedException {
    RemotePendant remotePendant =
        new RemotePendant(
            box.controller(), new PendantSetup("ur5e", ProgramsFolder.at(folder), folder));
    CountDownLatch seen = new CountDownLatch(1);
    box.serverContext().frames().add(new StartWatch(box.controller(), remotePendant)::look);
    box.serverContext().frames().add(state -> seen.countDown());
    seen.await();
    return remotePendant;
  }

  private static void await(RunningBox box, Predicate<ControllerState> wanted)
      throws InterruptedException {
    try (StateStream.Subscription frames = box.controller().feed().follow()) {
      while (!wanted.test(box.controller().state())) {
        var _ = frames.take();
      }
    }
  }

  private static boolean runs(ControllerState state) {
    return state.program().state() == ProgramState.RUNNING;
  }

  @Test
  void anEdgePlaysTheProgramThatWasLoadedAtTheStart() throws Exception {
    Files.writeString(folder.resolve("waits.script"), "def waits():\n  sleep(1000)\nend\n");
    try (RunningBox box = box("start-up program=\"waits.script\" start-input=\"digital_in[1]\"")) {
      RemotePendant remotePendant = panel(box);
      remotePendant.loadAtStart();
      assertEquals("waits.script", remotePendant.loaded().orElseThrow().name());
      assertEquals(Reply.done(), remotePendant.ask(new IoCommand.SetInput("digital_in[1]", true)));
      await(box, StartWatchTest::runs);
      assertEquals(Reply.done(), remotePendant.stop());
      await(box, state -> !runs(state));
      assertEquals(Reply.done(), remotePendant.ask(new IoCommand.SetInput("digital_in[1]", false)));
      assertEquals(Reply.done(), remotePendant.ask(new IoCommand.SetInput("digital_in[1]", true)));
      await(box, StartWatchTest::runs);
    }
  }

  @Test
  void theFallingEdgeIsLookedForWhereItIsChosen() throws Exception {
    Files.writeString(folder.resolve("waits.script"), "def waits():\n  sleep(1000)\nend\n");
    try (RunningBox box =
        box("start-up program=\"waits.script\" start-input=\"tool_in[0]\" start-on=low")) {
      RemotePendant remotePendant = panel(box);
      remotePendant.loadAtStart();
      assertEquals(Reply.done(), remotePendant.ask(new IoCommand.SetInput("tool_in[0]", true)));
      assertEquals(ProgramState.STOPPED, remotePendant.state().program().state());
      assertEquals(Reply.done(), remotePendant.ask(new IoCommand.SetInput("tool_in[0]", false)));
      await(box, StartWatchTest::runs);
    }
  }

  @Test
  void aProgramThatIsMissingIsTold() throws IOException, InterruptedException {
    try (RunningBox box = box("start-up program=\"no.script\"")) {
      RemotePendant remotePendant = panel(box);
      remotePendant.loadAtStart();
      await(
          box,
          state ->
              box.controller().logSince(0).stream()
                  .map(LogEntry::text)
                  .anyMatch(text -> text.startsWith("program no.script is not loaded")));
      assertTrue(remotePendant.loaded().isEmpty());
    }
  }
}
