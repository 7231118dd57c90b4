package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code pendant compare} with golden recordings of tests. */
class GoldenFileComparisonTest {
  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  private String golden(String name, String... lines) throws IOException {
    Path file = folder.resolve(name);
    List<String> all = new ArrayList<>(List.of("Pendant golden recording, version 1"));
    all.addAll(List.of(lines));
    Files.write(file, all);
    return file.toString();
  }

  private ExitCode compare(String... words) {
    List<String> line = new ArrayList<>(List.of("compare"));
    line.addAll(List.of(words));
    return new Pendant(new Console(output, errors)).run(line);
  }

  private String said() {
    return output.toString(StandardCharsets.UTF_8).replace(folder.toString(), "DIR");
  }

  private String complaint() {
    return errors.toString(StandardCharsets.UTF_8).replace(folder.toString(), "DIR");
  }

  private String moving(String name, double lastDeg, double switchS) throws IOException {
    return golden(
        name,
        "within 0.01 deg",
        "0.000 at 0 -90 -90 -90 90 0",
        switchS + " digital_out[2] on",
        "1.000 at " + lastDeg + " -90 -90 -90 90 0",
        "1.000 ends");
  }

  @Test
  void runsWithinTheUsualLimitsAreTheSame() throws IOException {
    assertEquals(
        ExitCode.DONE, compare(moving("a.golden", 10, 0.5), moving("b.golden", 10.05, 0.506)));
    assertEquals("the same within 0.1°, 0.01 s\n", said());
  }

  @Test
  void theFirstDifferenceIsToldWithBothValues() throws IOException {
    assertEquals(
        ExitCode.LIMIT_EXCEEDED, compare(moving("a.golden", 10, 0.5), moving("b.golden", 10, 0.6)));
    assertEquals(
        "DIR/a.golden: digital_out[2] goes on at 0.500 s, did at 0.600 s (may differ by 0.01 s)\n",
        said());
  }

  @Test
  void limitsAreThoseOfTheMark() throws IOException {
    assertEquals(
        ExitCode.DONE,
        compare(
            "--limit",
            "deg=5",
            "--limit",
            "s=0.2",
            moving("a.golden", 10, 0.5),
            moving("b.golden", 14, 0.6)));
    assertEquals("the same within 5°, 0.2 s\n", said());
  }

  @Test
  void otherLimitsAndThoseThatAFileCannotTellAreRefused() throws IOException {
    String file = moving("a.golden", 10, 0.5);

    assertEquals(ExitCode.WRONG_USAGE, compare("--limit", "duration=1", file, file));
    assertEquals(ExitCode.WRONG_USAGE, compare("--limit", "mm=1", file, file));
    assertEquals(
        List.of(
            "--limit duration: golden recordings have limits deg, mm and s",
            "DIR/a.golden has no places of the TCP, its test does not compare by mm"),
        complaint()
            .lines()
            .filter(each -> each.contains("golden"))
            .map(each -> each.replace("pendant compare: ", "").replace("pendant: ", ""))
            .toList());
  }

  @Test
  void aProgramIsNothingToCompareWith() throws IOException {
    Path program = Files.writeString(folder.resolve("p.script"), "textmsg(1)\n");

    assertEquals(ExitCode.WRONG_USAGE, compare(moving("a.golden", 10, 0.5), program.toString()));
    assertTrue(complaint().contains("p.script is no recording of a test"), complaint());
  }

  @Test
  void aFileThatIsNoneIsRefused() throws IOException {
    Path file = Files.writeString(folder.resolve("x.golden"), "nothing");

    assertEquals(ExitCode.WRONG_USAGE, compare(file.toString(), moving("a.golden", 10, 0.5)));
    assertTrue(complaint().contains("x.golden is no golden recording"), complaint());
  }
}
