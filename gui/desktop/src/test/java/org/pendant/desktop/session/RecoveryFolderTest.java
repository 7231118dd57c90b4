package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class RecoveryFolderTest {
  private static final Optional<Path> FILE = Optional.of(Path.of("/programs/p.script"));

  @TempDir Path folder;

  private RecoveryFolder of(long process, Predicate<Owner> alive) {
    return new RecoveryFolder(folder, new Owner(process, 1000), alive);
  }

  @Test
  void whatADeadProcessLeftIsFound() throws IOException {
    of(7, id -> true).keep(0, FILE, "p.script", "line\n\nmore");
    RecoveryFolder next = of(8, id -> false);
    RecoveryFolder.LeftBehind left = next.leftBehind().getFirst();
    assertEquals(FILE, left.file());
    assertEquals("p.script", left.name());
    assertEquals("line\n\nmore", left.text());
    next.forget(left);
    assertEquals(List.of(), next.leftBehind());
  }

  @Test
  void whatALivingProcessKeepsIsItsOwn() throws IOException {
    of(7, id -> true).keep(0, FILE, "p.script", "x");
    assertEquals(List.of(), of(8, id -> id.process() == 7).leftBehind());
  }

  @Test
  void aNumberThatTheSystemUsesAgainIsAnotherProcess() throws IOException {
    long self = ProcessHandle.current().pid();
    new RecoveryFolder(folder, new Owner(self, 1), owner -> true).keep(0, FILE, "p.script", "x");
    assertEquals(1, new RecoveryFolder(folder).leftBehind().size());
  }

  @Test
  void programsOfOneNameAreKeptBesideEachOther() throws IOException {
    RecoveryFolder recovery = of(7, id -> false);
    recovery.keep(0, Optional.empty(), "untitled", "one");
    recovery.keep(1, Optional.empty(), "untitled", "two");
    assertEquals(
        List.of("one", "two"),
        recovery.leftBehind().stream().map(RecoveryFolder.LeftBehind::text).toList());
  }

  @Test
  void whatIsSavedIsForgotten() throws IOException {
    RecoveryFolder recovery = of(7, id -> false);
    recovery.keep(3, Optional.empty(), "untitled", "x");
    recovery.forget(3);
    assertEquals(List.of(), recovery.leftBehind());
  }

  @Test
  void otherFilesAreLeftOut() throws IOException {
    Files.writeString(folder.resolve("x.recovery"), "something else");
    RecoveryFolder recovery = of(7, id -> false);
    assertEquals(List.of(), recovery.leftBehind());
    assertEquals(List.of(), new RecoveryFolder(folder.resolve("none")).leftBehind());
  }
}
