package org.pendant.protocols.robotapi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.PowerTimes;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.language.source.Source;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.teachpendant.PendantSetup;
import org.pendant.protocols.teachpendant.RemotePendant;
import org.pendant.script.vm.Program;

class RobotApiServerTest {
  private static final String WAITING = "def waits():\n  while True:\n    sleep(1)\n  end\nend\n";

  @TempDir Path folder;

  private final HttpClient client =
      HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
  private RunningBox box;
  private RemotePendant remotePendant;
  private RobotApiServer server;

  @BeforeEach
  void open() throws IOException {
    Files.createDirectories(folder.resolve("parts"));
    Files.writeString(folder.resolve("waits.script"), WAITING);
    Files.writeString(folder.resolve("broken.script"), "def p():\n");
    open(RemoteControl.disabled(), 0);
  }

  private void open(RemoteControl remote, double powerS) throws IOException {
    box =
        new RunningBox(
            ControllerOptions.headless()
                .withPower(false)
                .withPowerTimes(PowerTimes.ofTotal(powerS))
                .withOperator(Operator.present()),
            remote);
    remotePendant =
        new RemotePendant(
            box.controller(), new PendantSetup("ur10e", ProgramsFolder.at(folder), folder));
    server = RobotApiServer.open(box.serverContext(), PortNumbers.anyFree(), remotePendant);
  }

  @AfterEach
  void close() {
    client.close();
    server.close();
    box.close();
  }

  private void reopen(RemoteControl remote, double powerS) throws IOException {
    server.close();
    box.close();
    open(remote, powerS);
  }

  private HttpRequest.Builder request(String path) {
    return HttpRequest.newBuilder(
        URI.create(
            "http://127.0.0.1:"
                + server.ports().getFirst().number()
                + "/universal-robots/robot-api"
                + path));
  }

  private String send(HttpRequest request) throws IOException, InterruptedException {
    HttpResponse<String> answer =
        client.send(request, HttpResponse.BodyHandlers.ofString(StandardCharsets.UTF_8));
    assertEquals("application/json", answer.headers().firstValue("Content-Type").orElse(""));
    return answer.statusCode() + " " + answer.body();
  }

  private String get(String path) throws IOException, InterruptedException {
    return send(request(path).build());
  }

  private String put(String path, String body) throws IOException, InterruptedException {
    return send(request(path).PUT(HttpRequest.BodyPublishers.ofString(body)).build());
  }

  private void robot(String action) throws IOException, InterruptedException {
    String answer = put("/robotstate/v1/state", "{\"action\": \"" + action + "\"}");
    assertTrue(answer.startsWith("200 {\"state\":"), answer);
  }

  private void assertMode(String mode, String path) throws IOException, InterruptedException {
    assertEquals("200 " + mode(mode), get(path));
  }

  private static String mode(String mode) {
    return "{\"mode\":\"" + mode + "\",\"message\":\"the mode is " + mode + "\"}";
  }

  private String program(String action) throws IOException, InterruptedException {
    return put("/program/v1/state", "{\"action\":\"" + action + "\"}");
  }

  private void assertProgram(String state) throws IOException, InterruptedException {
    assertEquals(
        "200 {\"state\":\"" + state + "\",\"message\":\"the program is " + state + "\"}",
        get("/program/v1/state"));
  }

  /** Runs a program as an upload does. */
  private void run(String text) throws Exception {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    Program program = box.controller().load(Source.of("uploaded", bytes)).program().orElseThrow();
    box.controller().submit(new ProgramCommand.ReplaceProgram(program)).get();
  }

  @Test
  void saysWhichVersionThereIsAndWhatCanBeAsked() throws Exception {
    String description = get("/openapi.json");
    assertTrue(
        description.startsWith(
            "200 {\"openapi\":\"3.1.0\",\"info\":{\"title\":\"Robot API\",\"version\":\"3.1.4\"}"),
        description);
    for (Operation each : Operation.values()) {
      assertTrue(description.contains('"' + each.path() + "\":{"), each.path());
    }
    assertTrue(description.contains("\"/program/v1/state\":{\"get\":{"), description);
  }

  @Test
  void actionsAreAnsweredWhenTheyHaveComeAbout() throws Exception {
    reopen(RemoteControl.disabled(), 0.3);
    assertMode("POWER_OFF", "/robotstate/v1/robotmode");
    robot("POWER_ON");
    assertMode("IDLE", "/robotstate/v1/robotmode");
    robot("BRAKE_RELEASE");
    assertMode("RUNNING", "/robotstate/v1/robotmode/");
    robot("POWER_ON");
    assertMode("RUNNING", "/robotstate/v1/robotmode");
    robot("POWER_OFF");
    assertMode("POWER_OFF", "/robotstate/v1/robotmode");
    robot("BRAKE_RELEASE");
    assertMode("RUNNING", "/robotstate/v1/robotmode");
  }

  @Test
  void aProtectiveStopCanBeUnlockedAtOnce() throws Exception {
    robot("BRAKE_RELEASE");
    run("def p():\n  protective_stop()\n  sleep(1)\nend\n");
    while (!get("/robotstate/v1/safetymode").contains("PROTECTIVE_STOP")) {
      // the program is about to ask for the stop
    }
    robot("UNLOCK_PROTECTIVE_STOP");
    assertMode("NORMAL", "/robotstate/v1/safetymode");
    assertEquals(
        "409 {\"message\":\"unlock protective stop is not possible now\","
            + "\"details\":\"there is no protective stop to unlock\"}",
        put("/robotstate/v1/state", "{\"action\":\"UNLOCK_PROTECTIVE_STOP\"}"));
  }

  @Test
  void safetyModesHaveTheWordsOfTheApi() throws Exception {
    robot("BRAKE_RELEASE");
    box.controller()
        .submit(new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true))
        .get();
    while (!get("/robotstate/v1/safetymode").contains("\"EMERGENCY_STOP\"")) {
      // the next frame looks at the input
    }
    String refused = put("/robotstate/v1/state", "{\"action\":\"POWER_ON\"}");
    assertTrue(refused.startsWith("409 {\"message\":\"power on is not possible now\""), refused);
    box.controller()
        .submit(new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, false))
        .get();
    robot("RESTART_SAFETY");
    assertMode("POWER_OFF", "/robotstate/v1/robotmode");
  }

  @Test
  void aProgramIsLoadedPlayedPausedResumedAndStopped() throws Exception {
    assertEquals("200 {\"name\":\"\"}", get("/program/v1/loaded"));
    robot("BRAKE_RELEASE");
    assertEquals(
        "200 {\"name\":\"waits\",\"message\":\"the program is loaded\"}",
        put("/program/v1/loaded", "{\"name\":\"waits\"}"));
    assertEquals("200 {\"name\":\"waits\"}", get("/program/v1/loaded"));
    assertEquals("/programs/waits.script", remotePendant.loaded().orElseThrow().path());
    assertProgram("STOPPED");
    for (List<String> step :
        List.of(
            List.of("play", "PLAYING"),
            List.of("pause", "PAUSED"),
            List.of("resume", "PLAYING"),
            List.of("stop", "STOPPED"))) {
      String action = step.getFirst();
      String state = step.getLast();
      assertEquals(
          "200 {\"state\":\"" + state + "\",\"message\":\"" + action + " is done\"}",
          program(action));
      assertProgram(state);
    }
    String refused = program("resume");
    assertTrue(refused.contains("\"the program is STOPPED, must be PAUSED\""), refused);
    assertTrue(refused.startsWith("409 "), refused);
  }

  @Test
  void theOldNameOfLoadingStillWorks() throws Exception {
    assertTrue(put("/program/v1/load", "{\"programName\":\"waits.script\"}").startsWith("200 "));
    assertEquals("waits.script", remotePendant.loaded().orElseThrow().name());
  }

  @Test
  void whatCannotBeLoadedIsToldWithTheReason() throws Exception {
    assertEquals(
        "404 {\"message\":\"Program not found\",\"details\":\"none is not there, with none"
            + " of the endings .pendant, .urp, .script, .urpx\"}",
        put("/program/v1/loaded", "{\"name\":\"none\"}"));
    String broken = put("/program/v1/loaded", "{\"name\":\"broken\"}");
    assertTrue(
        broken.startsWith(
            "422 {\"message\":\"Program cannot be loaded\",\"details\":\"broken.script:"),
        broken);
    String outside = put("/program/v1/loaded", "{\"name\":\"../waits\"}");
    assertTrue(outside.startsWith("404 "), outside);
    assertTrue(remotePendant.loaded().isEmpty());
    assertTrue(program("play").startsWith("409 "));
  }

  @Test
  void programsAreListedByNameOnceEach() throws Exception {
    Files.writeString(folder.resolve("waits.pendant"), "");
    Files.writeString(folder.resolve("caf\u00e9.script"), WAITING);
    Files.writeString(folder.resolve("notes.txt"), "");
    Files.createDirectories(folder.resolve("folder.script"));
    Files.setLastModifiedTime(folder.resolve("waits.pendant"), FileTime.fromMillis(1_000_000));
    String list = get("/programs/v1/");
    assertTrue(list.endsWith("],\"message\":\"3 programs\"}"), list);
    assertTrue(list.indexOf("\"broken\"") < list.indexOf("\"caf\u00e9\""), list);
    assertTrue(list.contains("\"name\":\"waits\",\"description\":\"\",\"createdDate\":"), list);
    assertTrue(list.contains("\"lastModifiedDate\":1000,\"lastSavedDate\":1000"), list);
  }

  @Test
  void localControlForbidsActionsOnly() throws Exception {
    RemoteControl remote = new RemoteControl(true, false);
    reopen(remote, 0);
    assertMode("LOCAL", "/system/v1/controlmode");
    for (String path : List.of("/robotstate/v1/state", "/program/v1/state", "/program/v1/loaded")) {
      assertEquals(
          "403 {\"message\":\"Forbidden - Operation Not Allowed\",\"details\":\"the robot is in"
              + " local control, must be in remote\"}",
          put(path, "{}"));
    }
    assertMode("POWER_OFF", "/robotstate/v1/robotmode");
    remote.setRemote(true);
    assertMode("REMOTE", "/system/v1/controlmode");
    robot("POWER_ON");
  }

  @Test
  void withoutTheFeatureOfRemoteControlTheModeIsRemote() throws Exception {
    assertMode("REMOTE", "/system/v1/controlmode");
    assertMode("AUTOMATIC", "/system/v1/operationalmode");
  }

  @Test
  void pagesInABrowserMayNotControlTheRobot() throws Exception {
    HttpRequest fromPage =
        request("/robotstate/v1/state")
            .header("Origin", "http://127.0.0.1")
            .PUT(HttpRequest.BodyPublishers.ofString("{\"action\":\"POWER_ON\"}"))
            .build();
    assertEquals(
        "403 {\"message\":\"Forbidden - Operation Not Allowed\",\"details\":\"web pages may not"
            + " control it\"}",
        send(fromPage));
    assertMode("POWER_OFF", "/robotstate/v1/robotmode");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'' | body:1:1: the file is empty, must be an object",
        "[] | body:1:1: the body is an array of 0, must be an object",
        "{} | body:1:1: key \\\"action\\\" is missing, the body must have it",
        "{\"action\":1} | body:1:11: action is 1, must be a text",
        "{\"action\":\"jump\"} | action is \\\"jump\\\", must be play, pause, resume or stop"
      })
  void aBodyIsAnObjectWithAnActionThatThereIs(String body, String details) throws Exception {
    assertEquals(
        "422 {\"message\":\"Validation Error\",\"details\":\"" + details + "\"}",
        put("/program/v1/state", body));
  }

  @Test
  void otherPathsAndMethodsAreRefused() throws Exception {
    assertEquals(
        "404 {\"message\":\"Not Found\",\"details\":\"there is no"
            + " /universal-robots/robot-api/nothing\"}",
        get("/nothing"));
    assertTrue(get("").startsWith("404 "));
    HttpRequest delete = request("/program/v1/loaded").DELETE().build();
    assertEquals(
        "405 {\"message\":\"Method Not Allowed\",\"details\":\"must be GET or PUT\"}",
        send(delete));
    HttpResponse<String> answer = client.send(delete, HttpResponse.BodyHandlers.ofString());
    assertEquals("GET, PUT", answer.headers().firstValue("Allow").orElse(""));
  }
}
