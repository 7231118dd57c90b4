package org.pendant.command;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code pendant run} and {@code check} of a scene in which several controllers work. */
final class CellRunTest {
  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  @BeforeEach
  void writeFiles() throws IOException {
    write(
        "two.scene.json",
        """
        {
          "arms": [
            {"name": "left", "program": "left.script"},
            {"name": "right", "base": [3, 0, 0, 0, 0, 0], "program": "right.script"}
          ],
          "script": "plc.script",
          "wires": [
            ["left.digital_out[0]", "cell.digital_in[0]"],
            ["cell.digital_out[0]", "right.digital_in[0]"]
          ]
        }
        """);
    write(
        "left.script",
        """
        def left():
          textmsg("begins")
          set_standard_digital_out(0, True)
        end
        """);
    write(
        "right.script",
        """
        def right():
          while not get_standard_digital_in(0):
            sync()
          end
          textmsg("goes on")
        end
        """);
    write(
        "plc.script",
        """
        def plc():
          while True:
            set_standard_digital_out(0, get_standard_digital_in(0))
            sync()
          end
        end
        """);
  }

  private void write(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private String file(String name) {
    return folder.resolve(name).toString();
  }

  private ExitCode pendant(String... words) {
    output.reset();
    errors.reset();
    return new Pendant(new Console(output, errors)).run(List.of(words));
  }

  private ExitCode run(String... more) {
    String[] words = new String[3 + more.length];
    words[0] = "run";
    words[1] = "--scene";
    words[2] = file("two.scene.json");
    System.arraycopy(more, 0, words, 3, more.length);
    return pendant(words);
  }

  @Test
  void eachControllerSaysItsLinesBehindItsName() {
    assertEquals(ExitCode.DONE, run(), errors.toString(UTF_8));
    assertEquals("left: begins\nright: goes on\n", output.toString(UTF_8));
  }

  @Test
  void eachControllerHasARecordOfItsOwnThatRepeats() throws IOException {
    assertEquals(ExitCode.DONE, run("--record", file("a.rec")), errors.toString(UTF_8));
    assertEquals(ExitCode.DONE, run("--record", file("b.rec")), errors.toString(UTF_8));
    for (String name : List.of("left", "right", "cell")) {
      assertArrayEquals(
          Files.readAllBytes(folder.resolve("a." + name + ".rec")),
          Files.readAllBytes(folder.resolve("b." + name + ".rec")),
          name);
    }
  }

  @Test
  void aProgramThatFailsEndsTheOthersAndIsNamed() throws IOException {
    write("left.script", "def left():\n  n = 0\n  textmsg(1 / n)\nend\n");
    assertEquals(ExitCode.PROGRAM_FAILED, run());
    String said = errors.toString(UTF_8);
    assertTrue(said.contains("left: " + file("left.script") + ":3:"), said);
    assertTrue(said.contains("right.script: note: stopped, as left has stopped"), said);
  }

  @Test
  void timeIsUpForAll() throws IOException {
    write("left.script", "def left():\n  sleep(100)\nend\n");
    assertEquals(ExitCode.TIMED_OUT, run("--timeout", "1"));
    assertTrue(
        errors.toString(UTF_8).contains("left.script: error: stopped after 1.0 s, its time limit"),
        errors.toString(UTF_8));
  }

  @Test
  void theScriptOfTheCellCannotMoveWhatItHasNot() throws IOException {
    write("plc.script", "def plc():\n  movej([0, 0, 0, 0, 0, 0])\nend\n");
    assertEquals(ExitCode.DOES_NOT_COMPILE, pendant("check", file("two.scene.json")));
    String said = errors.toString(UTF_8);
    assertTrue(said.contains("plc.script:2:3: error: function movej needs an arm"), said);
  }

  @Test
  void aProgramThatIsNotThereIsToldAtItsPlace() throws IOException {
    Files.delete(folder.resolve("right.script"));
    assertEquals(ExitCode.WRONG_USAGE, run());
    assertTrue(
        errors
            .toString(UTF_8)
            .contains(
                "two.scene.json:4:62: program is \"right.script\", which is no file beside the"
                    + " scene"),
        errors.toString(UTF_8));
  }

  @Test
  void aTestKnowsHowNearAnotherArmIs() throws IOException {
    write(
        "near.scene.json",
        """
        {"arms": [{"name": "left"}, {"name": "right", "base": [0, 0.3, 0, 0, 0, 0]}]}
        """);
    write(
        "near_test.script",
        """
        # @scene near.scene.json
        def test_near():
          assert_near(min_distance(), 0.0369, 0.0002)
        end
        """);
    assertEquals(ExitCode.DONE, pendant("test", file("near_test.script")), errors.toString(UTF_8));
  }

  @Test
  void whatWorksWithOneControllerRefusesSeveral() {
    assertEquals(
        ExitCode.WRONG_USAGE,
        pendant("test", "--scene", file("two.scene.json"), file("left_test.script")));
    assertTrue(errors.toString(UTF_8).contains("has several controllers"), errors.toString(UTF_8));
  }
}
