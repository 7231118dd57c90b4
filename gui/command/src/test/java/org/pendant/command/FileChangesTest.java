package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class FileChangesTest {
  @TempDir private Path folder;

  private Path file(String name) throws IOException {
    return Files.writeString(folder.resolve(name), "def test_a():\nend\n");
  }

  @Test
  void aFileThatIsWrittenOrDeletedIsAChange() throws IOException {
    Path read = file("pick.script");
    FileChanges changes = new FileChanges(List.of(read.toString()), List.of(folder.toString()));
    assertFalse(changes.any());

    Files.setLastModifiedTime(read, FileTime.fromMillis(1000));
    assertTrue(changes.any());
    Files.delete(read);
    assertTrue(changes.any());
  }

  @Test
  void aNewFileOfTestsIsAChange() throws IOException {
    file("pick_test.script");
    FileChanges changes = new FileChanges(List.of(), List.of(folder.toString()));
    assertFalse(changes.any());

    file("other_test.script");
    assertTrue(changes.any());
  }
}
