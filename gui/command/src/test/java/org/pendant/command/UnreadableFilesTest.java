package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What commands say of files that they cannot read. */
final class UnreadableFilesTest {
  @TempDir private Path folder;

  /** The first line of complaints, with the folder left out. */
  private String complaint(String line) {
    List<String> words =
        Arrays.stream(line.split(" ", -1))
            .map(word -> word.contains(".") ? folder.resolve(word).toString() : word)
            .toList();
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    ExitCode code = new Pendant(new Console(new ByteArrayOutputStream(), errors)).run(words);
    assertEquals(ExitCode.WRONG_USAGE, code);
    return errors
        .toString(StandardCharsets.UTF_8)
        .lines()
        .findFirst()
        .orElseThrow()
        .replace(folder + "/", "");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "run none.script",
        "run none.pendant",
        "run --robot none.json a.script",
        "run --calibration none.conf a.script",
        "run --installation none.pinst a.script",
        "run --scene none.json a.script",
        "run --safety none.json a.script",
        "check none.script",
        "compare none.rec a.script",
        "compare none.csv a.script",
        "compare --collection none.txt --markdown page.md",
        "fit none.rec",
        "fit none.csv",
        "calibrate none.csv",
        "convert none.rec out.csv",
        "convert none.urp out.pendant",
        "convert none.installation out.pinst",
      })
  void aFileThatIsMissingIsToldInTheSameWordsByAll(String line) throws IOException {
    Files.writeString(folder.resolve("a.script"), "sync()\n");
    String missing =
        Arrays.stream(line.split(" ", -1)).filter(s -> s.startsWith("none.")).toList().getFirst();

    assertEquals(
        "pendant " + line.split(" ", -1)[0] + ": " + missing + ": there is no such file",
        complaint(line));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"compare folder.rec a.script", "fit folder.rec", "convert folder.rec a.csv"})
  void aFolderIsNoRecording(String line) throws IOException {
    Files.writeString(folder.resolve("a.script"), "sync()\n");
    Files.createDirectory(folder.resolve("folder.rec"));

    assertEquals(
        "pendant " + line.split(" ", -1)[0] + ": folder.rec is a directory, expected a recording",
        complaint(line));
  }

  @Test
  void aFileThatIsNoRecordingIsNamedOnce() throws IOException {
    Files.writeString(folder.resolve("table.rec"), "timestamp actual_q_0\n");

    assertEquals("pendant fit: table.rec: is no recording of Pendant", complaint("fit table.rec"));
  }
}
