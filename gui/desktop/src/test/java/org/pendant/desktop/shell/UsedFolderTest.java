package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class UsedFolderTest {
  private static final Path HOME = Path.of("/home/someone");

  @Test
  void dialogsBeginWhereTheProgramWasStartedAndThenWhereFilesWereOpened() {
    UsedFolder folder = new UsedFolder(Path.of("/programs"), HOME);
    assertEquals(Path.of("/programs"), folder.get());
    folder.chosen(Path.of("/cells/one/pick.script"));
    assertEquals(Path.of("/cells/one"), folder.get());
  }

  @Test
  void dialogsForWhatBelongsToAFileBeginBesideIt(@TempDir Path cell) {
    UsedFolder folder = new UsedFolder(Path.of("/programs"), HOME);
    Path program = cell.resolve("pick.pendant");
    assertEquals(cell, folder.beside(List.of(Optional.empty(), Optional.of(program))));
    Path gone = Path.of("/gone/away/cell.pinst");
    assertEquals(cell, folder.beside(List.of(Optional.of(gone), Optional.of(program))));
    assertEquals(Path.of("/programs"), folder.beside(List.of(Optional.empty())));
  }

  @Test
  void nobodyWorksInTheRoot() {
    assertEquals(HOME, new UsedFolder(Path.of("/"), HOME).get());
  }
}
