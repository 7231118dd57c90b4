package org.pendant.kit.export;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class SaveRequestTest {
  @TempDir private Path folder;

  private SaveRequest table(Path... inUse) {
    return new SaveRequest("Export", Path.of("log.csv"), List.of("csv", "txt"), List.of(inUse));
  }

  @Test
  void nameWithoutAnEndingGetsTheChosenOne() {
    assertEquals(folder.resolve("a.csv"), table().file(folder.resolve("a"), "csv"));
    assertEquals(folder.resolve("a.txt"), table().file(folder.resolve("a"), "txt"));
    assertEquals(folder.resolve("a.txt"), table().file(folder.resolve("a.txt"), "csv"));
  }

  @Test
  void endingFollowsTheChosenOne() {
    assertEquals("log.txt", table().withEnding("log.csv", "txt"));
    assertEquals("log.csv", table().withEnding("log.csv", "csv"));
    assertEquals("log.tar", table().withEnding("log.tar", "txt"));
    assertEquals("log", table().withEnding("log", "txt"));
    assertEquals("txt", table().ending("log.txt"));
    assertEquals("csv", table().ending("log"));
  }

  @Test
  void nameThatIsAskedForIsThatOfTheFile() {
    SaveRequest tree =
        new SaveRequest(
            "Save",
            Path.of("pick.pendant"),
            List.of("pendant"),
            path -> path.resolveSibling(path.getFileName() + ".pendant"),
            List.of());

    assertEquals(
        folder.resolve("my.cell.pendant"), tree.file(folder.resolve("my.cell"), "pendant"));
  }

  @Test
  void fileThatIsOpenIsRefusedByWhateverName() throws IOException {
    Path open = Files.writeString(folder.resolve("pick.script"), "");
    Path soft = Files.createSymbolicLink(folder.resolve("soft.csv"), open);
    Path hard = Files.createLink(folder.resolve("hard.csv"), open);
    SaveRequest request = table(folder.resolve("closed.script"), open);

    for (Path each :
        List.of(open, soft, hard, folder.resolve("../" + folder.getFileName() + "/pick.script"))) {
      assertEquals(
          Optional.of(each.getFileName() + " is open in this window, choose another name"),
          request.refusal(each));
    }
    assertEquals(Optional.empty(), request.refusal(folder.resolve("other.csv")));
    Path other = Files.writeString(folder.resolve("other.csv"), "");
    assertEquals(Optional.empty(), request.refusal(other));
  }
}
