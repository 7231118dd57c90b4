package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmFile;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;
import org.pendant.recording.RecordingFile;

/** {@code pendant compare}, mostly with recordings that Pendant has made itself. */
@Tag("slow")
final class CompareCommandTest {
  private static final Path RECORDINGS = Path.of("../../docs/recordings");

  private static final String PROGRAM =
      """
      def <move>():
        sleep(0.3)
        movej([0.4, -1.2, -1.4, -1.8, 1.5, 0.2], a=2, v=1)
        textmsg("there")
        movel(pose_add(get_actual_tcp_pose(), p[0, 0, -0.1, 0, 0, 0]), a=1.2, v=0.25)
        sleep(0.3)
      end
      """
          .replace("<move>", "move");

  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  @BeforeEach
  void writeProgram() throws IOException {
    Files.writeString(folder.resolve("move.script"), PROGRAM);
  }

  private ExitCode pendant(Object... words) {
    List<String> line = new ArrayList<>();
    for (Object each : words) {
      line.add(each.toString());
    }
    output.reset();
    errors.reset();
    return new Pendant(new Console(output, errors)).run(line);
  }

  private String said() {
    return output.toString(StandardCharsets.UTF_8);
  }

  private String complaints() {
    return errors.toString(StandardCharsets.UTF_8);
  }

  private Path file(String name) {
    return folder.resolve(name);
  }

  private Path record(String name) {
    ExitCode code = pendant("run", "--record", file(name), file("move.script"));
    assertEquals(ExitCode.DONE, code, complaints());
    return file(name);
  }

  /** Some of the rows, with another origin of time. */
  private Path thinned(Path table, int every) throws IOException {
    List<String> lines = Files.readAllLines(table);
    List<String> kept = new ArrayList<>(List.of(lines.getFirst()));
    for (int i = 1; i < lines.size(); i += every) {
      String[] cells = lines.get(i).split(",", 2);
      kept.add(Double.parseDouble(cells[0]) + 1234.5 + "," + cells[1]);
    }
    return Files.write(file("thinned.csv"), kept);
  }

  private JsonFields json(Path file) throws IOException, JsonException {
    try (InputStream in = Files.newInputStream(file)) {
      return new JsonFields(JsonFile.read(file.toString(), in), "comparison");
    }
  }

  @ParameterizedTest
  @CsvSource({"run.csv, 1", "run.csv, 10", "run.rec, 1"})
  void aRunAgreesWithItsOwnRecording(String name, int every) throws Exception {
    Path recorded = record(name);
    Path compared = every > 1 ? thinned(recorded, every) : recorded;

    ExitCode code =
        pendant(
            "compare",
            "--json",
            file("diff.json"),
            "--html",
            file("diff.html"),
            "--limit",
            "duration=0.001",
            "--limit",
            "path-max=0.1",
            "--limit",
            "target_q=0.0001",
            "--limit",
            "target_qd_0=0.005",
            compared,
            file("move.script"));

    assertEquals(ExitCode.DONE, code, said() + complaints());
    assertTrue(said().contains("limit duration: "), said());
    assertFalse(said().lines().anyMatch("there"::equals), "textmsg is no part of the tables");
    assertTrue(complaints().contains("there"), complaints());
    assertEquals("ur5e", json(file("diff.json")).text("robot").value());
    String page = Files.readString(file("diff.html"));
    assertTrue(page.contains("<svg") && !page.contains("href=") && !page.contains("src="), page);
  }

  @Test
  void theArmOfARecordingIsTheOneThatIsCompared() throws Exception {
    String text = ArmFile.text(ArmLibrary.load("ur10e"));
    String own = text.replace("\"massKg\" : 13.051", "\"massKg\" : 25");
    assertFalse(own.equals(text), "another arm");
    Files.writeString(file("own.json"), own);
    Files.writeString(
        file("arm.conf"),
        """
        delta_theta = [0.001, 0, 0, 0, 0, 0]
        delta_a = [0, 0, 0, 0, 0, 0]
        delta_d = [0.0004, 0, 0, 0, 0, 0]
        delta_alpha = [0, 0, 0, 0, 0, 0]
        """);
    Path recorded = file("own.rec");
    assertEquals(
        ExitCode.DONE,
        pendant(
            "run",
            "--robot",
            file("own.json"),
            "--calibration",
            file("arm.conf"),
            "--record",
            recorded,
            file("move.script")),
        complaints());
    ArmDescription arm = RecordingFile.open(recorded).recording().arm();
    assertEquals(25, arm.links().get(1).massKg());
    assertNotEquals(Calibration.NONE, arm.calibration());

    // of the first frame, before which no moments are known, 1.3 Nm rms come
    String[] limits = {"--limit", "target_moment=2", "--limit", "path-max=0.01"};
    assertEquals(
        ExitCode.DONE,
        pendant("compare", limits[0], limits[1], limits[2], limits[3], recorded, move()),
        said() + complaints());
    assertEquals(
        ExitCode.LIMIT_EXCEEDED,
        pendant("compare", "--robot", "ur10e", limits[0], limits[1], recorded, move()));
  }

  private Path move() {
    return file("move.script");
  }

  @Test
  void aLimitThatIsNotKeptGivesOne() throws Exception {
    Path recorded = record("run.csv");
    Files.writeString(file("move.script"), PROGRAM.replace("a=2, v=1", "a=1, v=1"));

    ExitCode code = pendant("compare", "--limit", "duration=0.01", recorded, file("move.script"));

    assertEquals(ExitCode.LIMIT_EXCEEDED, code, complaints());
    assertTrue(said().contains(" is above 0.0100"), said());
  }

  @Test
  void theSpeedSliderIsWhereItWas() throws Exception {
    List<String> lines = Files.readAllLines(record("run.csv"));
    List<String> slow = new ArrayList<>();
    for (String line : lines) {
      List<String> cells = List.of(line.split(",", -1)).subList(0, 7);
      String first = slow.isEmpty() ? "time_s" : 2 * Double.parseDouble(cells.getFirst()) + "";
      String fraction = slow.isEmpty() ? "target_speed_fraction" : "0.5";
      slow.add(first + "," + String.join(",", cells.subList(1, 7)) + "," + fraction);
    }
    Path half = Files.write(file("half.csv"), slow);

    ExitCode code = pendant("compare", "--limit", "half-duration=0.02", half, file("move.script"));

    assertEquals(ExitCode.DONE, code, said() + complaints());
  }

  @Test
  void namesInThePageAreText() throws Exception {
    Path recorded = record("run.csv");
    Path odd = Files.copy(recorded, file("<script>&.csv"));

    pendant("compare", "--html", file("diff.html"), odd, file("move.script"));

    String page = Files.readString(file("diff.html"));
    assertTrue(page.contains("&lt;script&gt;&amp;.csv"), page);
    assertFalse(page.contains("<script"), page);
  }

  @Test
  void aProgramWithoutEndIsStoppedAfterTheRecording() throws Exception {
    Path recorded = record("run.csv");
    Files.writeString(
        file("move.script"),
        PROGRAM.replace("  sleep(0.3)\nend", "  while True:\n    sync()\n  end\nend"));

    assertEquals(ExitCode.DONE, pendant("compare", recorded, file("move.script")), complaints());
    assertTrue(said().contains("duration"), said());
  }

  @Test
  void whatCannotBeComparedIsExplained() throws Exception {
    Path recorded = record("run.csv");
    Files.writeString(file("still.script"), "def still():\n  textmsg(1)\nend\n");
    Files.writeString(file("broken.csv"), "time_s,actual_q_0\n0,1\n");

    assertEquals(ExitCode.PROGRAM_FAILED, pendant("compare", recorded, file("still.script")));
    assertTrue(complaints().contains("did not move the arm"), complaints());
    assertEquals(ExitCode.WRONG_USAGE, pendant("compare", recorded));
    assertTrue(complaints().contains("expected a recording and a program"), complaints());
    assertEquals(ExitCode.WRONG_USAGE, pendant("compare", file("broken.csv"), file("move.script")));
    assertTrue(complaints().contains("broken.csv:2:1: there is neither actual_q_0"), complaints());
    assertEquals(
        ExitCode.WRONG_USAGE,
        pendant("compare", "--limit", "duratoin=1", recorded, file("move.script")));
    assertTrue(complaints().contains("did you mean duration?"), complaints());
    assertEquals(
        ExitCode.WRONG_USAGE,
        pendant("compare", "--limit", "duration", recorded, file("move.script")));
    assertTrue(complaints().contains("must be NAME=VALUE"), complaints());
    assertEquals(
        ExitCode.WRONG_USAGE, pendant("compare", "--cog", "1,2", recorded, file("move.script")));
    assertTrue(complaints().contains("three numbers"), complaints());
    assertEquals(
        ExitCode.WRONG_USAGE, pendant("compare", "--payload", "70", recorded, file("move.script")));
    assertTrue(complaints().contains("the payload is refused"), complaints());
  }

  @Test
  void movesOfARealArmTakeAsLongHere() {
    for (String name : List.of("ur3e-rad-3", "ur3e-rad-5")) {
      ExitCode code =
          pendant(
              "compare",
              "--robot",
              "ur3e",
              "--cog",
              "0,0,0.058",
              "--limit",
              "half-duration=0.01",
              "--limit",
              "path-max=0.2",
              RECORDINGS.resolve(name + ".csv"),
              RECORDINGS.resolve(name + ".script"));

      assertEquals(ExitCode.DONE, code, name + "\n" + said() + complaints());
    }
  }

  @Test
  void thePageAboutTheShippedRecordingsCanBeMade() throws IOException {
    ExitCode code =
        pendant(
            "compare",
            "--collection",
            RECORDINGS.resolve("recordings.txt"),
            "--markdown",
            file("fidelity.md"));

    assertEquals(ExitCode.DONE, code, complaints());
    String page = Files.readString(file("fidelity.md"));
    for (String name : List.of("ur3e-rad-1", "ur3e-rad-3", "ur3e-rad-5")) {
      assertTrue(page.contains(name + ".csv"), page);
      for (String quantity : List.of("target_qd", "target_moment", "actual_current")) {
        Path chart = file("fidelity").resolve(name + "-" + quantity + ".svg");
        assertTrue(Files.readString(chart).contains("<polyline"), chart.toString());
        assertTrue(page.contains("fidelity/" + chart.getFileName()), page);
      }
    }
    assertTrue(page.contains("| duration | s | "), page);
    assertEquals(
        ExitCode.WRONG_USAGE,
        pendant(
            "compare",
            "--collection",
            RECORDINGS.resolve("recordings.txt"),
            "--markdown",
            file("fidelity.md")));
    assertTrue(complaints().contains("--force replaces it"), complaints());
  }

  @Test
  void twoRecordingsAreComparedFrameByFrame() throws IOException {
    pendant("run", "--record", file("a.rec"), file("move.script"));
    pendant("run", "--record", file("b.rec"), file("move.script"));
    assertEquals(ExitCode.DONE, pendant("compare", file("a.rec"), file("b.rec")), errors::toString);
    assertTrue(said().startsWith("the same in all "), said());
    Files.writeString(folder.resolve("move.script"), PROGRAM.replace("v=1)", "v=0.5)"));
    pendant("run", "--record", file("c.rec"), file("move.script"));
    assertEquals(ExitCode.LIMIT_EXCEEDED, pendant("compare", file("c.rec"), file("a.rec")));
    assertTrue(said().contains("c.rec differs first "), said());
    assertTrue(said().contains("in line 3: target position of joint "), said());
    assertTrue(said().contains("The texts of the programs differ from line 3 on"), said());
  }

  @Test
  void aRecordingThatBeginsWhereTheArmCannotBeIsRefused() throws IOException {
    StringBuilder table = new StringBuilder("timestamp");
    for (int i = 0; i < 6; i++) {
      table.append(" actual_q_").append(i);
    }
    for (int row = 0; row < 100; row++) {
      table.append("\n").append(0.008 * row).append(" 0 -1.2 -1.4 -1.8 1.5 12.62563");
    }
    Path recording = Files.writeString(file("turned.csv"), table);
    assertEquals(ExitCode.WRONG_USAGE, pendant("compare", recording, file("move.script")));
    assertTrue(
        complaints()
            .contains(
                "the recording begins with joint 5 at 723.4°, but that of a UR5e turns from -360°"
                    + " to 360°; --robot says which arm was recorded"),
        complaints());
  }
}
