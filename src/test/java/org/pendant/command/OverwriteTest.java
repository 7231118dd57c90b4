package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher.Result;

/** A slip of a file name destroys nothing. */
@Tag("slow")
final class OverwriteTest {
  private static final String PROGRAM = "def own():\n  textmsg(\"runs\")\nend\n";
  private static final String NEVER = ", which this command reads and never overwrites";

  @TempDir Path folder;

  @BeforeEach
  void writeProgram() {
    Launcher.script(folder, "own.script", PROGRAM);
  }

  private String text(String name) throws IOException {
    return Files.readString(folder.resolve(name));
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(each -> each.getFileName().toString()).sorted().toList();
    }
  }

  /** Nothing has run, and the first line says why. */
  private static void assertRefused(String complaint, Result result) {
    assertEquals(2, result.exitCode(), result.errors());
    assertEquals("", result.output());
    assertEquals(complaint, result.errors().lines().findFirst().orElse(""));
  }

  @Test
  void recordIsNotWrittenOntoTheProgramByAnyName() throws IOException {
    Files.createDirectory(folder.resolve("m"));
    Files.createSymbolicLink(folder.resolve("soft.rec"), Path.of("own.script"));
    Files.createLink(folder.resolve("hard.csv"), folder.resolve("own.script"));

    for (String name : List.of("m/../own.script", "soft.rec", "hard.csv")) {
      assertRefused(
          "pendant run: --record "
              + name
              + " is the program own.script"
              + NEVER
              + ", not even with --force; choose another name",
          Launcher.pendant(folder, "run", "--force", "--record", name, "own.script"));
      assertEquals(PROGRAM, text("own.script"));
    }
    assertRefused(
        "pendant run: --record own.script is the program" + NEVER + "; choose another name",
        Launcher.pendant(folder, "run", "--record", "own.script", "own.script"));
    assertEquals(PROGRAM, text("own.script"));
  }

  @Test
  void recordIsNotWrittenOntoWhatATreeTakesFromItsFolder() throws IOException {
    String tree =
        """
        pendant program 1
        installation file="cell.pinst"
        main
          script-line code="textmsg(1)"
        """;
    Files.writeString(folder.resolve("say.pendant"), tree);
    Files.writeString(folder.resolve("cell.pinst"), "pendant installation 1\n");

    Result result =
        Launcher.pendant(folder, "run", "--force", "--record", "cell.pinst", "say.pendant");
    assertEquals(2, result.exitCode(), result.errors());
    assertTrue(result.errors().contains("is the installation"), result.errors());
    assertEquals("pendant installation 1\n", text("cell.pinst"));
  }

  @Test
  void recordIsNotWrittenOntoToolpathsThatTheProgramMayRead() throws IOException {
    Files.writeString(folder.resolve("flower.nc"), "G0 X0");

    Result result =
        Launcher.pendant(folder, "run", "--force", "--record", "flower.nc", "own.script");
    assertEquals(2, result.exitCode(), result.errors());
    assertTrue(result.errors().contains("is a toolpath"), result.errors());
    assertEquals("G0 X0", text("flower.nc"));
  }

  @Test
  void fileThatIsThereIsReplacedWithForceOnly() throws IOException {
    Files.writeString(folder.resolve("out.csv"), "a week of work");

    assertRefused(
        "pendant run: --record out.csv exists already, --force replaces it",
        Launcher.pendant(folder, "run", "--record", "out.csv", "own.script"));
    assertEquals("a week of work", text("out.csv"));

    Result forced = Launcher.pendant(folder, "run", "--force", "--record", "out.csv", "own.script");
    assertEquals(0, forced.exitCode(), forced.errors());
    assertTrue(
        forced.errors().startsWith("pendant run: note: --record out.csv is replaced when the run"),
        forced.errors());
    assertTrue(text("out.csv").startsWith("time_s,"), text("out.csv"));
    assertEquals(List.of("out.csv", "own.script"), names());
  }

  @Test
  void pictureIsWrittenOntoNothing() throws IOException {
    Files.writeString(folder.resolve("shot.png"), "a week of work");

    assertRefused(
        "pendant render: --out own.script is the program" + NEVER + "; choose another name",
        Launcher.pendant(folder, "render", "--out", "own.script", "own.script"));
    assertRefused(
        "pendant render: --out shot.png exists already, --force replaces it",
        Launcher.pendant(folder, "render", "--out", "shot.png", "own.script"));
    assertEquals(PROGRAM, text("own.script"));
    assertEquals("a week of work", text("shot.png"));
  }

  @Test
  void conversionIsNotWrittenOntoItsSource() throws IOException {
    String tree = "pendant program 1\nmain\n  comment text=\"mine\"\n";
    Files.writeString(folder.resolve("say.pendant"), tree);
    Files.createSymbolicLink(folder.resolve("other.script"), Path.of("say.pendant"));

    assertRefused(
        "pendant convert: other.script is the program say.pendant"
            + NEVER
            + ", not even with --force; choose another name",
        Launcher.pendant(folder, "convert", "--force", "say.pendant", "other.script"));
    assertEquals(tree, text("say.pendant"));
  }

  @Test
  void standardOutputTakesARecord() {
    Result result =
        Launcher.shell(folder, "\"$PENDANT\" run --record /dev/stdout own.script > all.txt");

    assertEquals(0, result.exitCode(), result.errors());
  }

  @Test
  void fullDiskCostsTheRestOfTheRecordAndNotTheRun() throws IOException {
    Launcher.script(
        folder,
        "long.script",
        "def long():\n  movej([0,-1.2,1.2,0,0,0])\n  textmsg(\"end\")\nend\n");
    Files.writeString(folder.resolve("old.rec"), "a week of work");
    // a limit for the size of files stands for the disk; the JVM itself writes none then
    String limited =
        "ulimit -f 100; export JDK_JAVA_OPTIONS=-XX:-UsePerfData; \"$PENDANT\" run long.script";

    for (String name : List.of("cut.rec", "cut.csv")) {
      Result result = Launcher.shell(folder, limited + " --record " + name);
      assertEquals(2, result.exitCode(), result.errors());
      assertEquals("end\n", result.output(), result.errors());
      assertEquals(
          1, result.errors().lines().filter(each -> each.contains("cannot be written")).count());
    }
    assertTrue(text("cut.csv").endsWith("\n"), "the table ends with a whole row");
    Result read = Launcher.pendant(folder, "convert", "cut.rec", "read.csv");
    assertEquals(0, read.exitCode(), read.errors());
    assertTrue(read.errors().contains("cut.rec is cut off: it ends at"), read.errors());

    Result forced = Launcher.shell(folder, limited + " --force --record old.rec");
    assertEquals(2, forced.exitCode(), forced.errors());
    assertEquals("a week of work", text("old.rec"));
    assertEquals(
        List.of("cut.csv", "cut.rec", "long.script", "old.rec", "own.script", "read.csv"), names());
  }

  @Test
  void fullDiskLeavesNoEmptyFile() throws IOException {
    Result run =
        Launcher.shell(
            folder,
            "ulimit -f 0; export JDK_JAVA_OPTIONS=-XX:-UsePerfData;"
                + " \"$PENDANT\" run --record new.rec own.script");

    assertEquals(2, run.exitCode(), run.errors());
    assertFalse(Files.exists(folder.resolve("new.rec")));
  }
}
