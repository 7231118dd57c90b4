package org.pendant.protocols.dashboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.zip.GZIPOutputStream;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.PowerTimes;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StateStream;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.teachpendant.PendantSetup;
import org.pendant.protocols.teachpendant.RemotePendant;
import org.pendant.script.vm.Program;

@Tag("slow")
class DashboardServerTest {
  private static final String LOCAL =
      "Command is not allowed due to safety reasons, please switch robot to Remote Control mode"
          + " and reconnect to port 29999";
  private static final String WAITING = "def waits():\n  while True:\n    sleep(1)\n  end\nend\n";
  private static final String TREE =
      "<?xml version=\"1.0\"?><URProgram name=\"waits\" installation=\"cell\"><children>"
          + "<MainProgram><children><Wait type=\"Sleep\"><waitTime>1</waitTime></Wait>"
          + "</children></MainProgram></children></URProgram>";

  @TempDir Path folder;

  private RunningBox box;
  private DashboardServer server;
  private DashboardTalk client;

  @BeforeEach
  void open() throws IOException {
    open(RemoteControl.disabled());
  }

  private void open(RemoteControl remote) throws IOException {
    Files.createDirectories(folder.resolve("programs/parts"));
    Files.writeString(folder.resolve("programs/waits.script"), WAITING);
    Files.write(folder.resolve("programs/waits.urp"), zipped(TREE));
    box =
        new RunningBox(
            ControllerOptions.headless()
                .withPower(false)
                .withPowerTimes(PowerTimes.ofTotal(0))
                .withOperator(Operator.present()),
            remote);
    RemotePendant remotePendant =
        new RemotePendant(
            box.controller(),
            new PendantSetup(
                "ur10e", ProgramsFolder.at(folder.resolve("programs")), folder.resolve("logs")));
    server = DashboardServer.open(box.serverContext(), PortNumbers.anyFree(), remotePendant);
    client = connect();
  }

  private DashboardTalk connect() throws IOException {
    return new DashboardTalk(server.ports().getFirst().number());
  }

  @AfterEach
  void close() throws IOException {
    client.close();
    server.close();
    box.close();
  }

  private static byte[] zipped(String text) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream zip = new GZIPOutputStream(bytes)) {
      zip.write(text.getBytes(StandardCharsets.UTF_8));
    }
    return bytes.toByteArray();
  }

  private void assertAnswers(String answer, String line) throws IOException {
    assertEquals(answer, client.ask(line));
  }

  private void running() throws IOException {
    client.ask("brake release");
    client.askUntil("robotmode", "Robotmode: RUNNING");
  }

  /** Starts a program as an upload does. */
  private void upload(String text) {
    Program program = TestController.program(box.controller(), text);
    box.controller().submit(new ProgramCommand.StartProgram(program)).join();
  }

  @Test
  void greets() {
    assertEquals("Connected: Universal Robots Dashboard Server", client.greeting());
  }

  @Test
  void answersLinesInTheirOrder() throws IOException {
    client.send("running\r\nROBOTMODE\nis In Remote control  \n");
    assertEquals("Program running: false", client.line());
    assertEquals("Robotmode: POWER_OFF", client.line());
    assertEquals("false", client.line());
  }

  @Test
  void leadsThroughAWholeCycle() throws IOException {
    assertAnswers("Powering on", "power on");
    client.askUntil("robotmode", "Robotmode: IDLE");
    assertAnswers("Brake releasing", "brake release");
    client.askUntil("robotmode", "Robotmode: RUNNING");
    assertAnswers("Loading program: waits.urp", "load waits.urp");
    assertAnswers("STOPPED waits.urp", "programState");
    assertAnswers("Starting program", "play");
    assertAnswers("PLAYING waits.urp", "programState");
    assertAnswers("Program running: true", "running");
    assertAnswers("Pausing program", "pause");
    assertAnswers("PAUSED waits.urp", "programState");
    assertAnswers("Starting program", "play");
    assertAnswers("PLAYING waits.urp", "programState");
    assertAnswers("Stopped", "stop");
    assertAnswers("STOPPED waits.urp", "programState");
    assertAnswers("Powering off", "power off");
    assertAnswers("Robotmode: POWER_OFF", "robotmode");
  }

  @Test
  void knowsTheLoadedProgram() throws IOException {
    assertAnswers("No program loaded", "get loaded program");
    assertAnswers("STOPPED <unnamed>", "programState");
    assertAnswers("false <unnamed>", "isProgramSaved");
    client.ask("load /programs/waits.urp");
    assertAnswers("Loaded program: /programs/waits.urp", "get loaded program");
    assertAnswers("true waits.urp", "isProgramSaved");
  }

  @Test
  void anUploadedProgramIsNotTheLoadedOne() throws IOException {
    running();
    client.ask("load waits.script");
    upload("def other():\n  sleep(100)\nend\n");
    assertAnswers("Program running: true", "running");
    assertAnswers("PLAYING waits.script", "programState");
    assertAnswers("Stopped", "stop");
    assertAnswers("Loaded program: /programs/waits.script", "get loaded program");
  }

  @Test
  void loadingStopsWhatRuns() throws IOException {
    running();
    upload("def other():\n  sleep(100)\nend\n");
    client.ask("load waits.urp");
    assertAnswers("STOPPED waits.urp", "programState");
  }

  @Test
  void playsTreesWithoutAScriptBesideThem() throws IOException {
    running();
    Files.writeString(folder.resolve("programs/plain.urp"), TREE);
    assertAnswers("Loading program: plain.urp", "load plain.urp");
    assertAnswers("Starting program", "play");
    assertAnswers("PLAYING plain.urp", "programState");
    Files.writeString(
        folder.resolve("programs/own.pendant"),
        "pendant program 1\nmain forever=true\n  wait what=time time-s=1\n");
    assertAnswers("Loading program: own.pendant", "load own.pendant");
    assertAnswers("Starting program", "play");
    assertAnswers("PLAYING own.pendant", "programState");
  }

  @Test
  void refusesProgramsThatAreNotThereOrBroken() throws IOException {
    assertAnswers("File not found: no.urp", "load no.urp");
    assertAnswers("File not found: no.script", "load no.script");
    assertAnswers("File not found: waits", "load waits");
    assertAnswers("File not found: ../secret.script", "load ../secret.script");
    assertAnswers("File not found: ", "load");
    Files.writeString(folder.resolve("programs/broken.script"), "def broken(:\n");
    assertAnswers("Error while loading program: broken.script", "load broken.script");
    Files.write(folder.resolve("programs/other.urp"), zipped("<Installation/>"));
    assertAnswers("Error while loading program: other.urp", "load other.urp");
    Files.writeString(
        folder.resolve("programs/empty.pendant"), "pendant program 1\nmain\n  move kind=joint\n");
    assertAnswers("Error while loading program: empty.pendant", "load empty.pendant");
    Files.writeString(folder.resolve("programs/side.script"), "sec side():\n  a = 1\nend\n");
    assertAnswers("Error while loading program: side.script", "load side.script");
    assertAnswers("No program loaded", "get loaded program");
  }

  @Test
  void refusesToPlayWithoutProgramOrPower() throws IOException {
    assertAnswers("Failed to execute: play", "play");
    assertTrue(nextLog().endsWith("no program is loaded"));
    client.ask("load waits.urp");
    assertAnswers("Failed to execute: play", "play");
    assertTrue(nextLog().contains("must be RUNNING"));
    assertAnswers("Failed to execute: pause", "pause");
  }

  private String nextLog() {
    try {
      return box.nextLogged();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void refusesToPlayWhatPlays() throws IOException {
    running();
    client.ask("load waits.urp");
    client.ask("play");
    assertAnswers("Failed to execute: play", "play");
    assertAnswers("PLAYING waits.urp", "programState");
  }

  @Test
  void stopNeedsAProgram() throws IOException {
    assertAnswers("Failed to execute: stop", "stop");
    client.ask("load waits.urp");
    assertAnswers("Stopped", "stop");
  }

  @Test
  void showsAndClosesPopups() throws IOException {
    assertAnswers("showing popup", "popup Close the Door");
    assertEquals("Close the Door", box.controller().state().openPopups().getFirst().text());
    assertAnswers("closing popup", "close popup");
    assertTrue(box.controller().state().openPopups().isEmpty());
    assertAnswers("closing popup", "close popup");
    assertAnswers("closing safety popup", "close safety popup");
  }

  @Test
  void closingAPopupLetsTheProgramGoOnThatWaitsForIt() throws Exception {
    running();
    upload("def asks():\n  popup(\"ready?\", blocking=True)\n  sleep(100)\nend\n");
    await(state -> !state.openPopups().isEmpty());
    client.ask("close popup");
    client.askUntil("running", "Program running: true");
  }

  private void await(Predicate<ControllerState> condition) throws InterruptedException {
    try (StateStream.Subscription frames = box.controller().feed().follow()) {
      while (!condition.test(box.controller().state())) {
        var _ = frames.take();
      }
    }
  }

  @Test
  void namesVersionModelAndSerialNumber() throws IOException {
    assertTrue(
        client
            .ask("PolyscopeVersion")
            .matches("URSoftware 5\\.24\\.1\\.\\d+ \\(\\w{3} \\d\\d \\d{4}\\)"));
    assertTrue(client.ask("version").matches("5\\.24\\.1\\.\\d+"));
    assertAnswers("UR10", "get robot model");
    assertTrue(client.ask("get serial number").matches("\\d+"));
  }

  @Test
  void keepsTheOperationalModeThatWasSet() throws IOException {
    assertAnswers("NONE", "get operational mode");
    assertAnswers("Operational mode 'Manual' is set", "set operational mode Manual");
    assertAnswers("MANUAL", "get operational mode");
    assertAnswers("Operational mode 'automatic' is set", "set operational mode automatic");
    assertAnswers("AUTOMATIC", "get operational mode");
    assertAnswers("Failed setting operational mode: half", "set operational mode half");
    assertAnswers(
        "No longer controlling the operational mode. Current operational mode: 'NONE'.",
        "clear operational mode");
    assertAnswers("NONE", "get operational mode");
  }

  @Test
  void tellsStopsFinelyAndCoarsely() throws IOException {
    assertAnswers("Safetystatus: NORMAL", "safetystatus");
    running();
    box.controller()
        .submit(new SafetyCommand.SetSafetyInput(SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP, true))
        .join();
    client.askUntil("safetystatus", "Safetystatus: AUTOMATIC_MODE_SAFEGUARD_STOP");
    assertAnswers("Safetymode: SAFEGUARD_STOP", "safetymode");
  }

  @Test
  void inManualModeTheSafeguardOfAutomaticModeDoesNotCount() throws IOException {
    running();
    box.controller()
        .submit(new SafetyCommand.SetSafetyInput(SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP, true))
        .join();
    client.askUntil("safetymode", "Safetymode: SAFEGUARD_STOP");
    client.ask("set operational mode manual");
    client.askUntil("safetymode", "Safetymode: NORMAL");
    client.ask("clear operational mode");
    client.askUntil("safetymode", "Safetymode: SAFEGUARD_STOP");
  }

  @Test
  void aProtectiveStopCannotBeUnlockedAtOnce() throws IOException {
    running();
    upload("def stops():\n  protective_stop()\nend\n");
    client.askUntil("safetymode", "Safetymode: PROTECTIVE_STOP");
    assertAnswers(
        "Cannot unlock protective stop until 5s after occurrence."
            + " Always inspect cause of protective stop before unlocking",
        "unlock protective stop");
  }

  @Test
  void unlockingWithoutAStopIsNoMistake() throws IOException {
    assertAnswers("Protective stop releasing", "unlock protective stop");
  }

  @Test
  void restartingSafetyLeavesTheArmOff() throws IOException {
    running();
    assertAnswers("Restarting safety", "restart safety");
    client.askUntil("robotmode", "Robotmode: POWER_OFF");
  }

  @Test
  void loadsInstallationsThatAreThere() throws IOException {
    Files.write(folder.resolve("programs/cell.installation"), zipped("<Installation/>"));
    assertAnswers("Loading installation: cell.installation", "load installation cell.installation");
    assertAnswers("File not found: no.installation", "load installation no.installation");
    Files.write(folder.resolve("programs/empty.installation"), new byte[0]);
    assertAnswers(
        "Failed to load installation: empty.installation", "load installation empty.installation");
  }

  @Test
  void aLoadedInstallationSetsTheControllerUp() throws IOException {
    Files.writeString(
        folder.resolve("programs/cell.pinst"),
        """
        pendant installation 1
        tool name="Gripper" in-flange=[0, 0, 0.12, 0, 0, 0]
        active-tool name="Gripper"
        """);
    assertAnswers("Loading installation: cell.pinst", "load installation cell.pinst");
    assertEquals("Gripper", box.controller().state().arm().tool().name());
    assertEquals(0.12, box.controller().state().arm().tool().inFlange().z());
  }

  @Test
  void anInstallationThatIsWrongChangesNothing() throws IOException {
    Files.writeString(
        folder.resolve("programs/wrong.pinst"), "pendant installation 1\nactive-tool name=\"x\"\n");
    assertAnswers("Failed to load installation: wrong.pinst", "load installation wrong.pinst");
    Files.writeString(folder.resolve("programs/odd.pinst"), "pendant installation 1\nodd\n");
    assertAnswers("Failed to load installation: odd.pinst", "load installation odd.pinst");
    assertEquals(Installation.NONE, box.controller().installation());
  }

  @Test
  void writesToTheLog() throws Exception {
    assertAnswers("Added log message", "addToLog Hello there");
    assertEquals("Hello there", box.nextLogged());
    assertAnswers("No log message to add", "addToLog ");
  }

  @Test
  void savesReports() throws IOException {
    client.ask("load waits.script");
    String answer = client.ask("generate flight report system");
    String begin = "Flight Report generated with id: ";
    assertTrue(answer.startsWith(begin), answer);
    Path report =
        folder.resolve(
            "logs/flightreports/flightreport-" + answer.substring(begin.length()) + ".zip");
    try (ZipFile zip = new ZipFile(report.toFile())) {
      assertNotEquals(null, zip.getEntry("state.txt"));
      byte[] program = zip.getInputStream(zip.getEntry("program/waits.script")).readAllBytes();
      assertEquals(WAITING, new String(program, StandardCharsets.UTF_8));
    }
    assertTrue(client.ask("generate flight report ").startsWith(begin));
    assertTrue(client.ask("generate flight report all").startsWith("Error: "));
    assertAnswers("Log saved to disk", "saveLog");
    assertTrue(Files.exists(folder.resolve("logs/log_history.txt")));
  }

  @Test
  void theSavedLogCannotActOnATerminal() throws Exception {
    Command line = new MessageCommand.WriteLog(Level.INFO, "\u001b]0;owned\u0007\rfake");
    var _ = box.controller().submit(line).get(RunningBox.GIVE_UP_MS, TimeUnit.MILLISECONDS);
    assertAnswers("Log saved to disk", "saveLog");
    String log = Files.readString(folder.resolve("logs/log_history.txt"));
    assertTrue(log.contains("\\x1b]0;owned\\x07\\x0dfake\n"), log);
  }

  @Test
  void savesSupportFilesInTheProgramsFolderOnly() throws IOException {
    String answer = client.ask("generate support file /programs/parts");
    String begin = "Completed successfully: ";
    assertTrue(answer.startsWith(begin), answer);
    Path file = Path.of(answer.substring(begin.length()));
    assertEquals(folder.resolve("programs/parts").toRealPath(), file.getParent());
    assertTrue(Files.size(file) > 0);
    for (String wrong : new String[] {"../..", "/tmp", "/programs/none", "waits.script"}) {
      String refusal = client.ask("generate support file " + wrong);
      assertTrue(refusal.startsWith("Error: "), refusal);
    }
  }

  @Test
  void saysWhatItDoesNotUnderstand() throws IOException {
    assertAnswers("could not understand: 'fly away'", "fly away");
    assertAnswers("could not understand: ''", "");
    assertAnswers("could not understand: 'setUserRole none'", "setUserRole none");
  }

  @Test
  void disconnectsWhoQuits() throws IOException {
    client.send("quit\npower on\n");
    assertEquals("Disconnected", client.line());
    assertTrue(client.ended());
    client = connect();
    assertAnswers("Robotmode: POWER_OFF", "robotmode");
  }

  @Test
  void endsTheBoxOnShutdown() throws Exception {
    assertAnswers("Shutting down", "shutdown");
    await(state -> state.safety().shutDown());
  }

  @Test
  void disconnectsWhoSendsALineWithoutEnd() throws Exception {
    client.send("x".repeat(70_000));
    assertTrue(client.ended());
    assertTrue(box.nextLogged().contains("a line has more than 65536 bytes"));
  }

  @Test
  void inLocalControlOnlyQuestionsAreAnswered() throws IOException {
    close();
    RemoteControl remote = new RemoteControl(true, false);
    open(remote);
    for (String action :
        new String[] {"power on", "load waits.urp", "play", "stop", "restart safety", "shutdown"}) {
      assertAnswers(LOCAL, action);
    }
    assertAnswers("Robotmode: POWER_OFF", "robotmode");
    assertAnswers("false", "is in remote control");
    assertAnswers("showing popup", "popup hello");
  }

  @Test
  void remoteControlNeedsAnotherConnection() throws IOException {
    close();
    RemoteControl remote = new RemoteControl(true, false);
    open(remote);
    remote.setRemote(true);
    assertAnswers("true", "is in remote control");
    assertAnswers(LOCAL, "power on");
    client.close();
    client = connect();
    assertAnswers("Powering on", "power on");
  }

  @Test
  void severalClientsAreServedAtOnce() throws IOException {
    try (DashboardTalk other = connect()) {
      client.send("robot");
      assertEquals("Robotmode: POWER_OFF", other.ask("robotmode"));
      client.send("mode\n");
      assertEquals("Robotmode: POWER_OFF", client.line());
    }
  }

  @Test
  void everyWordGetsOneLine() throws IOException {
    Map<DashboardCommand, String> arguments =
        Map.of(
            DashboardCommand.SET_OPERATIONAL_MODE, " manual", DashboardCommand.LOAD, " waits.urp");
    for (DashboardCommand word : DashboardCommand.values()) {
      if (word != DashboardCommand.QUIT) {
        String answer =
            client.ask(String.join(" ", word.words()) + arguments.getOrDefault(word, ""));
        assertFalse(answer.startsWith("could not understand"), word + ": " + answer);
        assertFalse(answer.isEmpty(), word.name());
      }
    }
  }
}
