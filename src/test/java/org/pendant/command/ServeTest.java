package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.client.Served;
import org.pendant.protocols.rtde.RtdeServer;

/** {@code pendant serve} as a system starts and ends it. */
@Tag("slow")
final class ServeTest {
  private static final int DASHBOARD = 29_999;
  private static final int PRIMARY = 30_001;

  /** The first address of several robots. */
  private static final int ROBOTS = 230;

  private static final int GIVE_UP_MS = 60_000;

  /** Between two offsets, so that none of the ports that stand close together is the same. */
  private static final int STEP = 25;

  /** With a larger offset, ports are among those that the system lends to any client. */
  private static final int OFFSETS = 1_700 / STEP;

  /** The owner of this port owns the offset. */
  private static final int CLAIM = 29_998;

  private ServerSocket claim;
  private int offset;

  @TempDir Path folder;

  /** Tests that run at the same time on one machine get ports of their own. */
  @BeforeEach
  void claimPorts() {
    int first = (int) (ProcessHandle.current().pid() % OFFSETS);
    offset =
        IntStream.range(0, OFFSETS)
            .map(i -> 1000 + STEP * ((first + i) % OFFSETS))
            .filter(each -> claimed(CLAIM + each))
            .findFirst()
            .orElseThrow();
  }

  private boolean claimed(int port) {
    try {
      claim = new ServerSocket(port, 1, InetAddress.getLoopbackAddress());
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  @AfterEach
  void giveBack() throws IOException {
    claim.close();
  }

  private Process serve(String... options) {
    List<String> words =
        new ArrayList<>(
            List.of("serve", "--port-offset", String.valueOf(offset), "--logs", "logs"));
    words.addAll(List.of(options));
    return Launcher.start(folder, words.toArray(String[]::new));
  }

  /** Reads what stands before the line {@code ready}. */
  private static List<String> untilReady(BufferedReader output) throws IOException {
    List<String> ports = new ArrayList<>();
    for (String line = output.readLine(); !"ready".equals(line); line = output.readLine()) {
      ports.add(String.valueOf(line));
      assertTrue(line != null, "never ready: " + ports);
    }
    return ports;
  }

  /** Sends lines to the dashboard server and answers what it said to the last. */
  private String dashboard(String... lines) throws IOException {
    return ask("127.0.0.1", DASHBOARD + offset, lines);
  }

  private static String ask(String host, int port, String... lines) throws IOException {
    try (Socket socket = new Socket(host, port)) {
      socket.setSoTimeout(GIVE_UP_MS);
      BufferedReader answers =
          new BufferedReader(
              new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
      String answer = answers.readLine();
      for (String line : lines) {
        socket.getOutputStream().write((line + "\n").getBytes(StandardCharsets.ISO_8859_1));
        answer = answers.readLine();
      }
      return answer;
    }
  }

  @ParameterizedTest
  @CsvSource({"TERM", "INT"})
  void aSignalEndsProgramAndServiceInOrder(String signal) throws Exception {
    Launcher.script(
        folder, "turns.script", "def turns():\n  textmsg(\"on \", 1)\n  sleep(1000)\nend\n");
    Process process = serve("--ready");
    try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
      List<String> ports = untilReady(output);
      assertTrue(ports.contains("Dashboard 127.0.0.1:" + (DASHBOARD + offset)), ports.toString());
      assertEquals("Starting program", dashboard("load turns.script", "play"));
      assertEquals("on 1", output.readLine());
      Process kill = new ProcessBuilder("kill", "-" + signal, Long.toString(process.pid())).start();
      assertEquals(0, kill.waitFor());
      assertEquals(0, Launcher.await(process));
    }
  }

  @Test
  void anInstallationSetsTheBoxUpAndNamesTheProgram() throws IOException {
    Launcher.script(folder, "asks.script", "def asks():\n  textmsg(get_tcp_offset())\nend\n");
    Files.writeString(
        folder.resolve("cell.pinst"),
        """
        pendant installation 1
        tool name="Gripper" in-flange=[0, 0, 0.25, 0, 0, 0]
        active-tool name="Gripper"
        start-up program="asks.script"
        """);
    Process process = serve("--ready", "--installation", "cell.pinst");
    try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
      untilReady(output);
      assertEquals("Loaded program: /programs/asks.script", dashboard("get loaded program"));
      assertEquals("Starting program", dashboard("play"));
      assertEquals("p[0, 0, 0.25, 0, 0, 0]", output.readLine());
      assertEquals("Shutting down", dashboard("shutdown"));
      assertEquals(0, Launcher.await(process));
    }
  }

  @Test
  void theCalibrationThatAnInstallationNamesIsSentAndUsed() throws IOException {
    Launcher.script(
        folder, "asks.script", "def asks():\n  textmsg(get_forward_kin([0,0,0,0,0,0]))\nend\n");
    Files.writeString(
        folder.resolve("arm.conf"),
        """
        delta_theta = [0.001, 0, 0, 0, 0, 0]
        delta_a = [0, 0.0004, 0, 0, 0, 0]
        delta_d = [0, 300.5, -300.5, 0, 0, 0]
        delta_alpha = [0, 0, 0, 0, 0, 0]
        joint_checksum = [0x11, 0x22, 0x33, 0x44, 0x55, 0x66]
        """);
    Files.writeString(
        folder.resolve("cell.pinst"),
        """
        pendant installation 1
        robot id="ur10e" calibration="arm.conf"
        start-up program="asks.script"
        """);
    Process process = serve("--ready", "--installation", "cell.pinst");
    try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
      untilReady(output);
      ByteBuffer kinematics = kinematics();
      assertEquals(0x33, kinematics.getInt(5 + 8));
      assertEquals(0.001, kinematics.getDouble(29));
      assertEquals(-0.6127 + 0.0004, kinematics.getDouble(85));
      assertEquals(300.5, kinematics.getDouble(133));
      assertEquals(2, kinematics.getInt(221));
      assertEquals("Starting program", dashboard("play"));
      assertEquals(
          "p[-1.183559, -0.291884, 0.06085, 1.570796, 0.000785, 0.000785]", output.readLine());
      dashboard("shutdown");
      assertEquals(0, Launcher.await(process));
    }
  }

  /** The kinematics part of the first whole state of the primary port. */
  private ByteBuffer kinematics() throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), PRIMARY + offset)) {
      socket.setSoTimeout(GIVE_UP_MS);
      DataInputStream in = new DataInputStream(socket.getInputStream());
      while (true) {
        byte[] message = new byte[in.readInt() - Integer.BYTES];
        in.readFully(message);
        ByteBuffer parts = ByteBuffer.wrap(message, 1, message.length - 1);
        while (message[0] == 16 && parts.hasRemaining()) {
          int at = parts.position();
          int size = parts.getInt(at);
          if (message[at + 4] == 5) {
            return parts.slice(at, size);
          }
          parts.position(at + size);
        }
      }
    }
  }

  @Test
  void shuttingTheBoxDownEndsTheServiceAndItsTraceHasThat() throws IOException {
    Process process = serve("--trace", "talk.jsonl");
    try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
      untilReady(output);
      assertEquals("Robotmode: POWER_OFF", dashboard("robotmode"));
      assertEquals("Shutting down", dashboard("shutdown"));
      assertEquals(0, Launcher.await(process));
    }
    List<String> acts =
        Files.readAllLines(folder.resolve("talk.jsonl")).stream()
            .filter(line -> line.contains("\"effect\":\"shutdown\""))
            .toList();
    assertEquals(1, acts.size());
  }

  @Test
  void readyMeansRunningAndInRemoteControl() throws IOException {
    Process process = serve("--ready");
    try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
      untilReady(output);
      assertEquals("Robotmode: RUNNING", dashboard("robotmode"));
      assertEquals("true", dashboard("is in remote control"));
      dashboard("shutdown");
      assertEquals(0, Launcher.await(process));
    }
  }

  @Test
  void severalRobotsHaveAddressesInARowAndEachItsOwnProgramAndLog() throws IOException {
    String first = Served.host(ROBOTS);
    String second = Served.host(ROBOTS + 1);
    Launcher.script(
        folder, "says.script", "def says():\n  textmsg(\"here\")\n  sleep(1000)\nend\n");
    Process process =
        Launcher.start(
            folder, "serve", "--robots", "2", "--host", first, "--ready", "--logs", "logs");
    try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
      List<String> ports = untilReady(output);
      assertTrue(ports.contains("Dashboard " + first + ":" + DASHBOARD), ports.toString());
      assertTrue(ports.contains("Dashboard " + second + ":" + DASHBOARD), ports.toString());
      assertEquals("Starting program", ask(second, DASHBOARD, "load says.script", "play"));
      assertEquals(second + ": here", output.readLine());
      assertEquals("No program loaded", ask(first, DASHBOARD, "get loaded program"));
      assertEquals("Shutting down", ask(first, DASHBOARD, "shutdown"));
      assertEquals("true", ask(second, DASHBOARD, "is in remote control"));
      assertEquals("Shutting down", ask(second, DASHBOARD, "shutdown"));
      assertEquals(0, Launcher.await(process));
    }
    assertTrue(Files.isDirectory(folder.resolve("logs").resolve(second + "-0")));
  }

  @Test
  void eachArmOfACellHasItsProgramLoaded() throws Exception {
    Files.writeString(folder.resolve("left.script"), "textmsg(\"here\")\n");
    Files.writeString(folder.resolve("right.script"), "textmsg(\"there\")\n");
    Files.writeString(
        folder.resolve("two.scene.json"),
        """
        {"arms": [
          {"name": "left", "program": "left.script"},
          {"name": "right", "base": [2, 0, 0, 0, 0, 0], "program": "right.script"}
        ]}
        """);
    Process process = serve("--ready", "--scene", "two.scene.json");
    try (BufferedReader output = process.inputReader(StandardCharsets.ISO_8859_1)) {
      untilReady(output);
      assertEquals("Loaded program: /programs/left.script", dashboard("get loaded program"));
      assertEquals("Starting program", ask("127.0.0.2", DASHBOARD + offset, "play"));
      assertEquals("right: there", output.readLine());
      assertEquals("Shutting down", dashboard("shutdown"));
      assertEquals("Shutting down", ask("127.0.0.2", DASHBOARD + offset, "shutdown"));
      assertEquals(0, Launcher.await(process));
    }
  }

  @Test
  void aPortThatIsTakenIsNamed() throws IOException {
    try (ServerSocket taken =
        new ServerSocket(DASHBOARD + offset, 1, InetAddress.getLoopbackAddress())) {
      Launcher.Result result =
          Launcher.pendant(folder, "serve", "--port-offset", String.valueOf(offset));
      assertEquals(69, result.exitCode());
      assertEquals("", result.output());
      assertTrue(
          result
              .errors()
              .startsWith(
                  "pendant serve: Dashboard: port "
                      + taken.getLocalPort()
                      + " of 127.0.0.1 cannot be had"),
          result.errors());
    }
  }

  @Test
  void startsWithoutAPortThatFewNeedAndSaysWhich() throws IOException {
    try (ServerSocket taken =
        new ServerSocket(30_013 + offset, 1, InetAddress.getLoopbackAddress())) {
      Process process = serve();
      try (BufferedReader output = process.inputReader(StandardCharsets.ISO_8859_1);
          BufferedReader errors = process.errorReader(StandardCharsets.ISO_8859_1)) {
        List<String> lines = untilReady(output);
        assertTrue(lines.stream().noneMatch(each -> each.startsWith("Realtime read-only")));
        assertTrue(
            errors
                .readLine()
                .startsWith(
                    "pendant serve: warning: Realtime read-only: port "
                        + taken.getLocalPort()
                        + " of 127.0.0.1 cannot be had"));
      } finally {
        process.destroy();
      }
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--port-offset=-1 | --port-offset is -1, must be a number from 0 to 11214",
        "--robots=0 | --robots is 0, must be a number from 1 to 100",
        "--modbus-port=x | --modbus-port is x, must be a number from 1 to 65535",
        "--robot-api=0 | --robot-api is 0, must be a number from 1 to 65535",
        "--programs=none | must be a folder",
        "--remote-control=on | --remote-control is on, must be enabled or disabled",
        "--power-time=-1 | --power-time is -1, must be 0 to 60 seconds",
        "--host=no.such.invalid | --host is no.such.invalid, must be an address of this machine",
        "--force | --force goes with --trace, which is missing",
        "a.script | takes no file, it was given a.script"
      })
  void refusesWrongOptions(String option, String message) {
    Launcher.Result result = Launcher.pendant(folder, "serve", option);
    assertEquals(2, result.exitCode());
    assertTrue(result.errors().contains(message), result.errors());
  }

  @Test
  void recordingItEndsByCtrlCWithAWholeTable() throws Exception {
    Process robot = serve("--ready");
    try (BufferedReader ready = robot.inputReader(StandardCharsets.UTF_8)) {
      untilReady(ready);
      Process recorder =
          Launcher.start(
              folder,
              "record",
              "--host",
              "127.0.0.1",
              "--port",
              String.valueOf(RtdeServer.STANDARD_PORT + offset),
              "--out",
              "out.csv");
      Path table = folder.resolve("out.csv");
      while (recorder.isAlive() && rows(table) < 100) {
        Thread.onSpinWait();
      }
      Process kill = new ProcessBuilder("kill", "-INT", Long.toString(recorder.pid())).start();
      assertEquals(0, kill.waitFor());
      String said = new String(recorder.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);

      assertEquals(0, Launcher.await(recorder), said);
      assertTrue(said.contains(" rows, "), said);
      String text = Files.readString(table);
      assertTrue(text.endsWith("\n"), "the table ends in the middle of a row");
      List<String> lines = text.lines().toList();
      int cells = lines.getFirst().split(" ", -1).length;
      assertTrue(lines.stream().allMatch(each -> each.split(" ", -1).length == cells), said);
    } finally {
      robot.destroy();
    }
  }

  private static long rows(Path table) throws IOException {
    return Files.exists(table) ? Files.readAllLines(table).size() : 0;
  }
}
