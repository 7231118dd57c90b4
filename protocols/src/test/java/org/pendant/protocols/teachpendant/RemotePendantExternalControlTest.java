package org.pendant.protocols.teachpendant;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.StateStream;
import org.pendant.protocols.ClosedPort;
import org.pendant.protocols.dashboard.DashboardServer;
import org.pendant.protocols.dashboard.DashboardTalk;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.externalcontrol.Drivers;
import org.pendant.protocols.externalcontrol.FakeDriver;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.script.function.ScriptPlace;
import org.pendant.script.vm.ProgramState;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
class RemotePendantExternalControlTest {
  private static final String NODE =
      "<Contributed strategyClass=\"com.fzi.externalcontrol.ExternalControlNode\""
          + " strategyProgramNodeType=\"External Control\""
          + " strategyURCapName=\"External Control\"><dataModel/></Contributed>";

  private static final String SCRIPT =
      """
      # HEADER_BEGIN
      greeting = "hello"
      def greet():
        textmsg(greeting)
      end
      # HEADER_END
      greet()
      """;

  @TempDir Path folder;
  private RunningBox box;

  @BeforeEach
  void open() {
    box = new RunningBox(ControllerOptions.headless(), RemoteControl.disabled());
  }

  @AfterEach
  void close() {
    box.close();
  }

  private void save(String name, String nodes) throws IOException {
    Files.writeString(
        folder.resolve(name),
        "<URProgram name=\"drive\"><children><MainProgram runOnlyOnce=\"true\"><children>"
            + nodes
            + "</children></MainProgram></children></URProgram>");
  }

  private RemotePendant panel(Optional<ControlHost> chosen) {
    Drivers drivers = new Drivers(AllowedHosts.ANY, chosen);
    return new RemotePendant(
        box.controller(), new PendantSetup("ur5e", ProgramsFolder.at(folder), folder, drivers));
  }

  private void awaitEnd() throws InterruptedException {
    try (StateStream.Subscription frames = box.controller().feed().follow()) {
      while (box.controller().state().program().state() != ProgramState.STOPPED) {
        var _ = frames.take();
      }
    }
  }

  private List<String> said() {
    return box.controller().logSince(0).stream()
        .filter(each -> each.origin() == LogEntry.Origin.SCRIPT)
        .map(LogEntry::text)
        .toList();
  }

  @Test
  void theDriverIsAskedAtEveryStart() throws Exception {
    save("drive.urp", NODE);
    try (FakeDriver driver = new FakeDriver(SCRIPT)) {
      RemotePendant remotePendant = panel(Optional.of(driver.host()));
      remotePendant.load("drive.urp");
      assertEquals(List.of(), driver.questions());
      for (int run = 0; run < 2; run++) {
        assertEquals(Reply.done(), remotePendant.play());
        awaitEnd();
      }
      assertEquals(List.of("hello", "hello"), said());
      assertEquals(List.of("request_program", "request_program"), driver.questions());
    }
  }

  @Test
  void severalNodesShareOneScriptAndItsHeader() throws Exception {
    save(
        "drive.urp",
        NODE
            + "<Script type=\"Line\"><expression><ExpressionChar character=\"g\"/>"
            + "<ExpressionChar character=\"r\"/><ExpressionChar character=\"e\"/>"
            + "<ExpressionChar character=\"e\"/><ExpressionChar character=\"t\"/>"
            + "<ExpressionChar character=\"(\"/><ExpressionChar character=\")\"/></expression>"
            + "</Script>"
            + NODE);
    try (FakeDriver driver = new FakeDriver(SCRIPT)) {
      RemotePendant remotePendant = panel(Optional.of(driver.host()));
      remotePendant.load("drive.urp");
      assertEquals(Reply.done(), remotePendant.play());
      awaitEnd();
      assertEquals(List.of("hello", "hello", "hello"), said());
      assertEquals(List.of("request_program"), driver.questions());
    }
  }

  @Test
  void theInstallationSaysWhomToAsk() throws Exception {
    save("drive.urp", NODE);
    try (FakeDriver driver = new FakeDriver(SCRIPT)) {
      Files.writeString(
          folder.resolve("cell.pinst"),
          "pendant installation 1\nexternal-control host=\"127.0.0.1\" port="
              + driver.host().port()
              + "\n");
      RemotePendant remotePendant = panel(Optional.empty());
      remotePendant.load("drive.urp");
      remotePendant.loadInstallation("cell.pinst");
      assertEquals(Reply.done(), remotePendant.play());
      awaitEnd();
      assertEquals(List.of("hello"), said());
    }
  }

  @Test
  void nobodyIsAskedForSuppressedNodes() throws Exception {
    save("drive.urp", "<SuppressedNode><children>" + NODE + "</children></SuppressedNode>");
    try (FakeDriver driver = new FakeDriver(SCRIPT)) {
      RemotePendant remotePendant = panel(Optional.of(driver.host()));
      remotePendant.load("drive.urp");
      assertEquals(Reply.done(), remotePendant.play());
      awaitEnd();
      assertEquals(List.of(), driver.questions());
    }
  }

  @Test
  void aProgramDoesNotStartWithoutTheDriverAndTheLogSaysWhy() throws Exception {
    save("drive.urp", NODE);
    try (ClosedPort closed = new ClosedPort()) {
      ControlHost gone = new ControlHost("127.0.0.1", closed.number());
      RemotePendant remotePendant = panel(Optional.of(gone));
      try (DashboardServer server =
              DashboardServer.open(box.serverContext(), PortNumbers.anyFree(), remotePendant);
          DashboardTalk client = new DashboardTalk(server.ports().getFirst().number())) {
        assertEquals("Loading program: drive.urp", client.ask("load drive.urp"));
        assertEquals("Failed to execute: play", client.ask("play"));
        assertEquals("STOPPED drive.urp", client.ask("programState"));
      }
      assertEquals(
          "dashboard: play: External Control: nobody answers at "
              + gone.text()
              + " (connection refused); the driver must be running",
          box.nextLogged());
    }
  }

  @Test
  void theDashboardStartsAProgramWithADriver() throws Exception {
    save("drive.urp", NODE);
    try (FakeDriver driver = new FakeDriver(SCRIPT.replace("greet()\n", "greet()\nsleep(100)\n"))) {
      RemotePendant remotePendant = panel(Optional.of(driver.host()));
      try (DashboardServer server =
              DashboardServer.open(box.serverContext(), PortNumbers.anyFree(), remotePendant);
          DashboardTalk client = new DashboardTalk(server.ports().getFirst().number())) {
        assertEquals("Loading program: drive.urp", client.ask("load drive.urp"));
        assertEquals("Starting program", client.ask("play"));
        assertEquals("PLAYING drive.urp", client.ask("programState"));
        assertEquals("Stopped", client.ask("stop"));
      }
    }
  }

  @Test
  void whatIsWrongInTheScriptIsToldWithItsLineThere() throws Exception {
    save("drive.urp", NODE);
    String broken = SCRIPT.replace("textmsg(greeting)", "textmsg(greetings, )");
    try (FakeDriver driver = new FakeDriver(broken)) {
      RemotePendant remotePendant = panel(Optional.of(driver.host()));
      remotePendant.load("drive.urp");
      String why = remotePendant.play().complaint().orElseThrow();
      String place = "line 4 of the script from " + driver.host().text() + ": drive.urp.script:";
      assertTrue(why.startsWith(place), why);
      assertEquals(ProgramState.STOPPED, remotePendant.state().program().state());
    }
  }

  @Test
  void aFailureInTheScriptIsKnownByItsLineThere() throws Exception {
    save("drive.urp", NODE);
    String fails = SCRIPT.replace("textmsg(greeting)", "textmsg([1][norm(5)])");
    try (FakeDriver driver = new FakeDriver(fails)) {
      RemotePendant remotePendant = panel(Optional.of(driver.host()));
      remotePendant.load("drive.urp");
      assertEquals(Reply.done(), remotePendant.play());
      awaitEnd();
      ScriptPlace place =
          box.controller().logSince(0).stream()
              .filter(each -> each.origin() == LogEntry.Origin.ENDING)
              .flatMap(each -> each.place().stream())
              .findFirst()
              .orElseThrow();
      assertEquals(
          Optional.of("line 4 of the script from " + driver.host().text()),
          remotePendant.receivedAt(place.source(), place.line()));
      assertEquals(Optional.empty(), remotePendant.receivedAt(place.source(), 1));
      assertEquals(Optional.empty(), remotePendant.receivedAt("other.script", place.line()));
    }
  }

  @Test
  void aStopInTheMomentInWhichADriverIsAskedEndsTheStart() throws Exception {
    save("drive.urp", NODE);
    CompletableFuture<RemotePendant> pendant = new CompletableFuture<>();
    CompletableFuture<Reply> stopped = new CompletableFuture<>();
    try (FakeDriver driver =
        new FakeDriver(
            client -> {
              // the first thing that happens: the driver has been asked this very moment
              stopped.complete(pendant.join().stop());
              client.write('#');
            })) {
      RemotePendant remotePendant = panel(Optional.of(driver.host()));
      remotePendant.load("drive.urp");
      pendant.complete(remotePendant);
      assertTrue(remotePendant.play().complaint().isPresent());
      assertEquals(Reply.done(), stopped.join());
      assertEquals(ProgramState.STOPPED, remotePendant.state().program().state());
    }
  }

  @Test
  void aStopEndsAStartThatWaitsForTheDriver() throws Exception {
    save("drive.urp", NODE);
    CountDownLatch asked = new CountDownLatch(1);
    CountDownLatch over = new CountDownLatch(1);
    try (FakeDriver slow =
        new FakeDriver(
            client -> {
              // a line without an end
              try {
                do {
                  client.write('#');
                  asked.countDown();
                } while (!over.await(50, TimeUnit.MILLISECONDS));
              } catch (InterruptedException e) {
                throw new IOException(e);
              }
            })) {
      RemotePendant remotePendant = panel(Optional.of(slow.host()));
      remotePendant.load("drive.urp");
      CompletableFuture<Reply> started = CompletableFuture.supplyAsync(remotePendant::play);
      asked.await();
      assertEquals(Reply.done(), remotePendant.stop());
      assertEquals(
          Optional.of(
              "External Control: stopped while "
                  + slow.host().text()
                  + " was asked for the script"),
          started.join().complaint());
      assertEquals(ProgramState.STOPPED, remotePendant.state().program().state());
    } finally {
      over.countDown();
    }
  }
}
