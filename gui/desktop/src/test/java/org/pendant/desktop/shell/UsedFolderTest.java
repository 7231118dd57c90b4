package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;

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
  void nobodyWorksInTheRoot() {
    assertEquals(HOME, new UsedFolder(Path.of("/"), HOME).get());
  }
}
