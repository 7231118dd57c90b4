package org.pendant.controller.disk;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class AtomicFileTest {
  private static final String OLD = "what was there";
  private static final String NEW = "what comes in its place, ".repeat(10_000);

  @TempDir Path folder;

  private Path file() {
    return folder.resolve("pick.script");
  }

  private static void write(Path file, String text) throws IOException {
    AtomicFile.write(file, text.getBytes(UTF_8));
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(each -> each.getFileName().toString()).sorted().toList();
    }
  }

  private static String rights(Path file) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(file));
  }

  @Test
  void isThereAloneAfterwards() throws IOException {
    write(file(), OLD);
    write(file(), NEW);

    assertEquals(NEW, Files.readString(file()));
    assertEquals(List.of("pick.script"), names());
  }

  @Test
  void isOnTheDiskBeforeItTakesTheNameAndItsFolderAfterwards() throws IOException {
    FailingDisk disk = new FailingDisk(100);
    AtomicFile.write(disk, file(), out -> out.write(1), Rights.USUAL);

    assertEquals(List.of("create", "write", "sync", "replace", "sync folder"), disk.steps());
  }

  @Test
  void whateverStepFailsTheOldFileIsWholeAndNothingIsLeftBeside() throws IOException {
    write(file(), OLD);
    int working = 0;
    while (true) {
      FailingDisk disk = new FailingDisk(working);
      try {
        AtomicFile.write(disk, file(), out -> out.write(NEW.getBytes(UTF_8)), Rights.USUAL);
        break;
      } catch (IOException e) {
        assertEquals(file() + ": no space left on device", e.getMessage());
      }
      String where = "failed at " + disk.steps();
      assertEquals(OLD, Files.readString(file()), where);
      assertEquals(List.of("pick.script"), names(), where);
      working++;
    }
    assertTrue(working >= 4, working + " steps have failed");
    assertEquals(NEW, Files.readString(file()));
  }

  @Test
  void whateverStepFailsNoNewFileIsThere() throws IOException {
    int working = 0;
    while (true) {
      FailingDisk disk = new FailingDisk(working);
      try {
        AtomicFile.create(disk, file(), out -> out.write(NEW.getBytes(UTF_8)));
        break;
      } catch (IOException e) {
        assertEquals(List.of(), names(), "failed at " + disk.steps());
      }
      working++;
    }
    assertTrue(working >= 4, working + " steps have failed");
    assertEquals(NEW, Files.readString(file()));
    assertEquals(List.of("pick.script"), names());
  }

  @Test
  void contentThatGivesUpLeavesTheOldFile() throws IOException {
    write(file(), OLD);
    assertThrows(
        IllegalStateException.class,
        () ->
            AtomicFile.write(
                file(),
                out -> {
                  out.write(NEW.getBytes(UTF_8));
                  throw new IllegalStateException("no more");
                }));

    assertEquals(OLD, Files.readString(file()));
    assertEquals(List.of("pick.script"), names());
  }

  @Test
  void creatingDoesNotReplace() throws IOException {
    write(file(), OLD);
    IOException refusal =
        assertThrows(IOException.class, () -> AtomicFile.create(file(), out -> out.write(1)));

    assertEquals(file() + ": " + file() + " is in the way", refusal.getMessage());
    assertEquals(OLD, Files.readString(file()));
  }

  @Test
  void creatingDoesNotReplaceWhatHasComeMeanwhile() throws IOException {
    assertThrows(
        IOException.class, () -> AtomicFile.create(file(), out -> Files.writeString(file(), OLD)));

    assertEquals(OLD, Files.readString(file()));
    assertEquals(List.of("pick.script"), names());
  }

  @Test
  void newFileHasTheRightsOfAnyNewFile() throws IOException {
    Path usual = Files.writeString(folder.resolve("usual"), "");
    write(file(), NEW);

    assertEquals(rights(usual), rights(file()));
  }

  @Test
  void fileThatIsReplacedHandsOnItsRights() throws IOException {
    for (String rights : List.of("rw-------", "rwxrwxrwx", "rw-rw----")) {
      write(file(), OLD);
      Files.setPosixFilePermissions(file(), PosixFilePermissions.fromString(rights));
      write(file(), NEW);

      assertEquals(rights, rights(file()));
    }
  }

  @Test
  void privateFileIsForItsOwnerOnly() throws IOException {
    AtomicFile.writePrivate(file(), new byte[1]);

    assertEquals("rw-------", rights(file()));
  }

  @Test
  void linkStaysAndWhatItLeadsToIsReplaced() throws IOException {
    Path away = Files.createDirectory(folder.resolve("away"));
    Path target = Files.writeString(away.resolve("target.script"), OLD);
    Files.createSymbolicLink(away.resolve("second"), Path.of("target.script"));
    Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("away/second"));
    write(link, NEW);

    assertTrue(Files.isSymbolicLink(link));
    assertTrue(Files.isSymbolicLink(away.resolve("second")));
    assertEquals(NEW, Files.readString(target));
  }

  @Test
  void linkToNothingStaysAndLeadsToTheNewFile() throws IOException {
    Path link = Files.createSymbolicLink(file(), Path.of("later.script"));
    write(link, NEW);

    assertTrue(Files.isSymbolicLink(link));
    assertEquals(NEW, Files.readString(folder.resolve("later.script")));
  }

  @Test
  void linksInALoopAreRefused() throws IOException {
    Files.createSymbolicLink(folder.resolve("a"), Path.of("b"));
    Path loop = Files.createSymbolicLink(folder.resolve("b"), Path.of("a"));

    IOException refusal = assertThrows(IOException.class, () -> write(loop, NEW));
    assertEquals(loop + ": its links form a loop", refusal.getMessage());
  }

  @Test
  void otherHardLinkKeepsTheOldText() throws IOException {
    write(file(), OLD);
    Path other = Files.createLink(folder.resolve("other"), file());
    write(file(), NEW);

    assertEquals(NEW, Files.readString(file()));
    assertEquals(OLD, Files.readString(other));
  }

  @Test
  void foldersAreMade() throws IOException {
    Path deep = folder.resolve("a/b/c.script");
    write(deep, NEW);

    assertEquals(NEW, Files.readString(deep));
  }

  @Test
  void folderIsRefused() {
    IOException refusal = assertThrows(IOException.class, () -> write(folder, NEW));

    assertEquals(folder + ": it is a folder", refusal.getMessage());
  }

  @Test
  void longNamesAreWritten() throws IOException {
    Path file = folder.resolve("\u00e4".repeat(120) + ".script");
    write(file, NEW);

    assertEquals(NEW, Files.readString(file));
  }

  @Test
  void deviceIsWrittenStraight() throws IOException {
    Path nothing = Path.of("/dev/null");
    assumeTrue(Files.exists(nothing));
    write(nothing, NEW);

    assertFalse(Files.isRegularFile(nothing));
  }

  @Test
  void fullDeviceIsTold() {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.exists(full));
    IOException refusal = assertThrows(IOException.class, () -> write(full, NEW));

    assertEquals("/dev/full: no space left on device", refusal.getMessage());
    assertTrue(Files.exists(full));
  }
}
