package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.world.SceneObject;

@Tag("slow")
final class RenderCommandTest {
  private static final String MOVE =
      """
      def move():
        movej([0, -1.2, 1.2, -1.57, -1.57, 0], a=1.4, v=1)
        textmsg("there")
      end
      """;

  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();
  private final FakeRenderer renderer = new FakeRenderer();
  private Path program;
  private Path picture;

  @BeforeEach
  void write() throws IOException {
    program = Files.writeString(folder.resolve("move.script"), MOVE);
    picture = folder.resolve("shot.png");
  }

  private ExitCode run(List<String> words) {
    DesktopServices services =
        new DesktopServices(Optional::empty, () -> Optional.of(() -> renderer));
    return new Pendant(new Console(output, errors), services).run(words);
  }

  /** Answers the number of the exit code. */
  private int render(String... more) {
    Stream<String> words =
        Stream.concat(Stream.of("render", program.toString(), "--size", "120x80"), Stream.of(more));
    return run(words.toList()).number();
  }

  private String complaint() {
    return errors.toString(StandardCharsets.UTF_8).lines().findFirst().orElse("");
  }

  private String text() {
    return output.toString(StandardCharsets.UTF_8);
  }

  private int refused(String... more) {
    int code = render(more);
    assertFalse(Files.exists(picture));
    assertEquals("", text());
    return code;
  }

  @Test
  void drawsTheEndOfAProgram() throws IOException {
    assertEquals(0, render("--out", picture.toString()));

    assertEquals(120, renderer.picture().widthPx());
    assertEquals(80, renderer.picture().heightPx());
    assertEquals(-1.2, renderer.picture().arm().actualPositionRad().get(1), 1e-3);
    assertEquals("drawn", Files.readString(picture));
    assertEquals("there\n", text());
  }

  @Test
  void drawsAMomentAndStopsThere() {
    assertEquals(0, render("--out", picture.toString(), "--at", "0.2"));

    assertEquals("", text());
    assertEquals(0.2, renderer.lastS(), 1e-6);
  }

  @Test
  void drawsObjectsWhereTheyAreThen() throws IOException {
    Path scene = folder.resolve("cell.scene.json");
    Files.writeString(
        scene,
        "{\"objects\": [{\"type\": \"sphere\", \"name\": \"ball\", \"centre\": [1, 0, 1],"
            + " \"radius\": 0.1, \"mass\": 1}]}");
    assertEquals(
        0, render("--out", picture.toString(), "--at", "0.2", "--scene", scene.toString()));

    SceneObject.Sphere ball = (SceneObject.Sphere) renderer.picture().world().objects().getFirst();
    assertEquals(1 - 0.5 * 9.82 * 0.04, ball.centreInBaseM().z(), 0.01);
  }

  @Test
  void saysWhenTheProgramHadEndedBefore() {
    assertEquals(0, render("--out", picture.toString(), "--at", "1000"));

    assertTrue(complaint().endsWith("note: ended before --at; the picture shows its end"));
    assertTrue(Files.exists(picture));
  }

  @Test
  void aProgramThatFailsIsDrawnWhereItStopped() throws IOException {
    Files.writeString(program, "def fail():\n  x = [1][3]\nend\n");

    assertEquals(1, render("--out", picture.toString()));
    assertTrue(complaint().contains("index is 3, must be 0 to 0"), complaint());
    assertTrue(Files.exists(picture));
  }

  @Test
  void aProgramThatDoesNotCompileIsNotDrawn() throws IOException {
    Files.writeString(program, "def broken(\n");

    assertEquals(3, refused("--out", picture.toString()));
  }

  @Test
  void aPictureMustBeNamed() {
    assertEquals(2, refused());
    assertEquals("pendant render: no picture named, expected --out FILE.png", complaint());
  }

  @Test
  void aFolderThatIsNotThereIsRefusedBeforeTheProgramRuns() {
    String out = folder.resolve("none").resolve("shot.png").toString();

    assertEquals(2, refused("--out", out));
    assertEquals(
        "pendant render: --out "
            + out
            + ": cannot be written, there is no folder "
            + folder.resolve("none"),
        complaint());
  }

  @Test
  void wrongNumbersAndWordsAreRefused() {
    String out = picture.toString();
    for (List<String> each :
        List.of(
            List.of("--at", "soon", "--at is soon, must be at least 0 seconds"),
            List.of("--at", "-1", "--at is -1, must be at least 0 seconds"),
            List.of(
                "--view", "up", "--view is up, must be one of iso, front, back, left, right, top"),
            List.of("--theme", "blue", "--theme is blue, must be light or dark"))) {
      errors.reset();
      assertEquals(2, refused("--out", out, each.get(0), each.get(1)));
      assertEquals("pendant render: " + each.get(2), complaint());
    }
  }

  @Test
  void aSizeMustBeTwoNumbersOfPixels() {
    for (String size : List.of("12", "0x80", "5000x80", "axb", "1280X800")) {
      errors.reset();
      assertEquals(
          ExitCode.WRONG_USAGE,
          run(List.of("render", program.toString(), "--out", picture.toString(), "--size", size)));
      assertEquals(
          "pendant render: --size is "
              + size
              + ", must be width x height in pixels such as 1280x800, each 16 to 4096",
          complaint());
    }
  }

  @Test
  void onlyOneProgramIsDrawn() {
    assertEquals(2, refused("--out", picture.toString(), program.toString()));
    assertEquals("pendant render: expected one file, there are 2", complaint());
  }

  @Test
  void graphicsEndWithTheCommand() {
    render("--out", picture.toString());

    assertTrue(renderer.closed());
  }

  @Test
  void withoutADesktopNothingIsDrawnAndNothingRuns() {
    DesktopServices none = new DesktopServices(Optional::empty, Optional::empty);

    ExitCode code =
        new Pendant(new Console(output, errors), none)
            .run(List.of("render", program.toString(), "--out", picture.toString()));

    assertEquals(ExitCode.UNAVAILABLE, code);
    assertEquals("pendant render: cannot draw: the desktop is not on the class path", complaint());
    assertEquals("", text());
  }
}
