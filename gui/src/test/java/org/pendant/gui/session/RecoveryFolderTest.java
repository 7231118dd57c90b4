package org.pendant.gui.session;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class RecoveryFolderTest {
  private static final Optional<Path> FILE = Optional.of(Path.of("/programs/p.script"));

  @TempDir Path folder;

  @Test
  void whatADeadProcessLeftIsFound() throws IOException {
    new RecoveryFolder(folder, 7, id -> true).keep(FILE, "p.script", "line\n\nmore");
    RecoveryFolder next = new RecoveryFolder(folder, 8, id -> false);
    RecoveryFolder.LeftBehind left = next.leftBehind().getFirst();
    assertEquals(FILE, left.file());
    assertEquals("p.script", left.name());
    assertEquals("line\n\nmore", left.text());
    next.forget(left);
    assertEquals(List.of(), next.leftBehind());
  }

  @Test
  void whatALivingProcessKeepsIsItsOwn() throws IOException {
    new RecoveryFolder(folder, 7, id -> true).keep(FILE, "p.script", "x");
    assertEquals(List.of(), new RecoveryFolder(folder, 8, id -> id == 7).leftBehind());
  }

  @Test
  void whatIsSavedIsForgotten() throws IOException {
    RecoveryFolder recovery = new RecoveryFolder(folder, 7, id -> false);
    recovery.keep(Optional.empty(), "untitled", "x");
    recovery.forget(Optional.empty(), "untitled");
    assertEquals(List.of(), recovery.leftBehind());
  }

  @Test
  void otherFilesAreLeftOut() throws IOException {
    Files.writeString(folder.resolve("x.recovery"), "something else");
    RecoveryFolder recovery = new RecoveryFolder(folder, 7, id -> false);
    assertEquals(List.of(), recovery.leftBehind());
    assertEquals(
        List.of(), new RecoveryFolder(folder.resolve("none"), 7, id -> false).leftBehind());
  }
}
