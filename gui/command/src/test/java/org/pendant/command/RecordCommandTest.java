package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.WallClock;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.language.source.Source;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.rtde.RtdeServer;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.compare.Samples;

/** {@code pendant record} with a controller of Pendant's own. */
@Tag("slow")
final class RecordCommandTest {
  private static final String PROGRAM =
      "def move():\n  movej([0.3, -1.4, -1.6, -1.7, 1.5, 0.1], a=2, v=1)\nend\n";

  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final FrameLoop loop = FrameLoop.start(controller, new WallClock());
  private final PeerLog log = new PeerLog((level, text) -> {});
  private final StateBroadcaster frames = new StateBroadcaster(controller.feed(), log);
  private final RtdeServer server = open();

  private RtdeServer open() {
    try {
      return RtdeServer.open(
          new ServerContext(controller, frames, log, RemoteControl.disabled()),
          PortNumbers.anyFree());
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @AfterEach
  void close() {
    server.close();
    frames.close();
    loop.close();
  }

  private ExitCode record(int port, Path out, String... more) {
    List<String> words =
        new ArrayList<>(
            List.of("record", "--host", "127.0.0.1", "--port", Integer.toString(port), "--out"));
    words.add(out.toString());
    words.addAll(List.of(more));
    return pendant(words);
  }

  private ExitCode pendant(List<String> words) {
    output.reset();
    errors.reset();
    return new Pendant(new Console(output, errors)).run(words);
  }

  private int port() {
    return server.ports().getFirst().number();
  }

  private String complaints() {
    return errors.toString(StandardCharsets.UTF_8);
  }

  @Test
  void aTableHasTheChosenFieldsAtTheChosenRate() throws IOException {
    Path out = folder.resolve("out.csv");

    ExitCode code =
        record(
            port(),
            out,
            "--fields",
            "timestamp,actual_q,robot_mode",
            "--frequency",
            "250",
            "--seconds",
            "0.2");

    assertEquals(ExitCode.DONE, code, complaints());
    List<String> lines = Files.readAllLines(out);
    assertEquals(
        "timestamp actual_q_0 actual_q_1 actual_q_2 actual_q_3 actual_q_4 actual_q_5 robot_mode",
        lines.getFirst());
    assertEquals(1 + 50, lines.size());
    double before = Double.parseDouble(lines.get(1).split(" ", -1)[0]);
    double after = Double.parseDouble(lines.get(2).split(" ", -1)[0]);
    assertEquals(0.004, after - before, 1e-9);
    assertTrue(lines.get(1).endsWith(" 7"), lines.get(1));
    assertTrue(complaints().contains("50 rows, 0.2 s, are in out.csv"), complaints());
  }

  @Test
  void whatIsRecordedCanBeCompared() throws IOException {
    Path out = folder.resolve("out.csv");
    Path program = Files.writeString(folder.resolve("move.script"), PROGRAM);
    Source source = Source.of("move.script", PROGRAM);
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                controller.load(source).program().orElseThrow(), Optional.empty()));

    assertEquals(ExitCode.DONE, record(port(), out, "--seconds", "2.5"), complaints());
    ExitCode code =
        pendant(List.of("compare", "--limit", "path-max=5", out.toString(), program.toString()));

    assertEquals(ExitCode.DONE, code, complaints());
  }

  private void start() {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                controller.load(Source.of("move.script", PROGRAM)).program().orElseThrow(),
                Optional.empty()));
  }

  private static Samples samples(Path file) throws UsageException {
    return RecordedFile.read(file.toString(), file, OptionalDouble.empty()).samples();
  }

  @Test
  void aRecordingHasTheColumnsOfTheTable() throws IOException, UsageException {
    Path table = folder.resolve("out.csv");
    Path out = folder.resolve("out.rec");
    start();

    ExitCode code =
        record(port(), table, "--out", out.toString(), "--robot", "ur5e", "--seconds", "2");

    assertEquals(ExitCode.DONE, code, complaints());
    assertTrue(complaints().contains("250 rows, 2.0 s, are in out.csv, out.rec"), complaints());
    Samples inTable = samples(table);
    Samples inRecording = samples(out);
    assertEquals(250, inTable.rows());
    assertEquals(inTable.quantities(), inRecording.quantities());
    assertEquals(inTable.rows(), inRecording.rows());
    for (int row = 0; row < inTable.rows(); row++) {
      assertEquals(inTable.timeS(row), inRecording.timeS(row));
      for (StateQuantity each : inTable.quantities()) {
        assertArrayEquals(
            inTable.values(each, row), inRecording.values(each, row), each.name() + " " + row);
      }
    }
    List<String> headings = List.of(Files.readAllLines(table).getFirst().split(" ", -1));
    assertEquals(headings, RecordingFile.open(out).recording().receivedColumns());
  }

  @Test
  void aRecordingCanBeComparedFittedAndMadeATable() throws IOException {
    Path out = folder.resolve("out.rec");
    Path program = Files.writeString(folder.resolve("move.script"), PROGRAM);
    start();
    assertEquals(
        ExitCode.DONE, record(port(), out, "--robot", "ur5e", "--seconds", "2.5"), complaints());

    assertEquals(
        ExitCode.DONE,
        pendant(List.of("compare", "--limit", "path-max=5", out.toString(), program.toString())),
        complaints());
    assertEquals(ExitCode.DONE, pendant(List.of("fit", out.toString())), complaints());
    Path table = folder.resolve("made.csv");
    assertEquals(
        ExitCode.DONE, pendant(List.of("convert", out.toString(), table.toString())), complaints());
    assertTrue(
        Files.readAllLines(table).getFirst().contains(",var:timestamp,var:target_q_0"), "columns");
  }

  @Test
  void fieldsThatThereAreNotAreRefused() {
    Path out = folder.resolve("out.csv");

    assertEquals(ExitCode.WRONG_USAGE, record(port(), out, "--fields", "timestamp,actual_p"));
    assertTrue(complaints().contains("the controller has no field actual_p"), complaints());
    assertFalse(Files.exists(out), "nothing was written");
  }

  @Test
  void aControllerThatIsNotThereIsToldAndNothingWritten() throws IOException {
    int free;
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      free = socket.getLocalPort();
    }
    Path out = folder.resolve("out.csv");

    assertEquals(ExitCode.UNAVAILABLE, record(free, out));
    assertTrue(complaints().contains("127.0.0.1:" + free + ": cannot be reached"), complaints());
    assertFalse(Files.exists(out), "nothing was written");
  }

  @Test
  void wrongUseIsExplained() throws IOException {
    Path out = Files.writeString(folder.resolve("out.csv"), "mine");

    assertEquals(ExitCode.WRONG_USAGE, record(port(), out));
    assertTrue(complaints().contains("--force replaces it"), complaints());
    assertEquals("mine", Files.readString(out));
    Path recording = folder.resolve("out.rec");
    assertEquals(ExitCode.WRONG_USAGE, record(port(), recording));
    assertTrue(complaints().contains("RTDE does not tell: --robot"), complaints());
    assertEquals(
        ExitCode.WRONG_USAGE,
        record(port(), recording, "--robot", "ur5e", "--fields", "timestamp,target_q"));
    assertTrue(complaints().contains("must have timestamp and actual_q"), complaints());
    assertFalse(Files.exists(recording), "nothing was written");
    assertEquals(ExitCode.WRONG_USAGE, pendant(List.of("record")));
    assertTrue(complaints().contains("expected --host ROBOT"), complaints());
    assertEquals(ExitCode.DONE, record(port(), out, "--force", "--seconds", "0.1"), complaints());
    assertTrue(Files.readString(out).startsWith("timestamp target_q_0"), "the table");
  }

  @Test
  void whatWasThereWhenTheControllerWentIsKept() throws Exception {
    Path out = folder.resolve("out.csv");
    Thread going =
        Thread.ofPlatform()
            .start(
                () -> {
                  // a row is there as soon as the table has more than its header
                  while (lines(out) < 100) {
                    Thread.onSpinWait();
                  }
                  server.close();
                });

    ExitCode code = record(port(), out, "--fields", "timestamp", "--frequency", "500");
    going.join();

    assertEquals(ExitCode.UNAVAILABLE, code, complaints());
    assertTrue(complaints().contains("the connection is lost"), complaints());
    assertTrue(lines(out) >= 100, "rows are kept");
  }

  private static long lines(Path file) {
    try {
      return Files.exists(file) ? Files.readAllLines(file).size() : 0;
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }
}
