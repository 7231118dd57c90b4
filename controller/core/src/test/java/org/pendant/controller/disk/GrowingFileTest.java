package org.pendant.controller.disk;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class GrowingFileTest {
  @TempDir Path folder;

  private Path file() {
    return folder.resolve("run.rec");
  }

  private static void write(GrowingFile file, String text) throws IOException {
    file.write(text.getBytes(UTF_8));
    file.flush();
  }

  @Test
  void partsAreThereWhenTheyWereFlushed() throws IOException {
    try (GrowingFile growing = GrowingFile.create(file())) {
      write(growing, "first,");
      assertEquals("first,", Files.readString(file()));
      growing.write("second".getBytes(UTF_8));
      assertEquals("first,", Files.readString(file()));
    }
    assertEquals("first,second", Files.readString(file()));
  }

  @Test
  void partThatFailsIsNotThereAtAll() throws IOException {
    FailingDisk disk = new FailingDisk(4);
    try (GrowingFile growing = GrowingFile.create(disk, file())) {
      write(growing, "first,");
      write(growing, "second,");
      assertThrows(IOException.class, () -> write(growing, "third,"));
      assertEquals("first,second,", Files.readString(file()));
      assertThrows(IOException.class, () -> write(growing, "fourth,"));
    } catch (IOException e) {
      // This disk does not even sync any more.
      assertEquals(
          List.of("create", "write", "rename", "write", "write", "sync", "sync folder"),
          disk.steps());
    }
    assertEquals("first,second,", Files.readString(file()));
  }

  @Test
  void fileThatIsThereGoesOnBehindWhatIsKeptOfIt() throws IOException {
    Files.writeString(file(), "first,sec");
    try (GrowingFile growing = GrowingFile.resume(file(), "first,".length())) {
      assertEquals("first,", Files.readString(file()));
      write(growing, "second");
    }
    assertEquals("first,second", Files.readString(file()));
    assertThrows(
        IOException.class, () -> GrowingFile.resume(folder.resolve("nothing.rec"), 1).close());
  }

  @Test
  void fileWithoutAPartIsRemoved() throws IOException {
    GrowingFile growing = GrowingFile.create(new FailingDisk(1), file());
    assertThrows(IOException.class, () -> write(growing, "first,"));
    assertThrows(IOException.class, growing::close);

    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(List.of(), files.toList());
    }
  }

  @Test
  void nameIsThereWithTheFirstPart() throws IOException {
    try (GrowingFile growing = GrowingFile.create(file())) {
      growing.write("first".getBytes(UTF_8));
      assertFalse(Files.exists(file()));
      growing.flush();
      assertEquals("first", Files.readString(file()));
    }
  }

  @Test
  void fileThatHasComeMeanwhileIsNotReplaced() throws IOException {
    try (GrowingFile growing = GrowingFile.create(file())) {
      Files.writeString(file(), "old");
      assertThrows(FileAlreadyExistsException.class, () -> write(growing, "first"));
    }
    assertEquals("old", Files.readString(file()));
  }

  @Test
  void fileThatIsThereIsRefused() throws IOException {
    Files.writeString(file(), "old");
    assertThrows(FileAlreadyExistsException.class, () -> GrowingFile.create(file()));

    assertEquals("old", Files.readString(file()));
  }

  @Test
  void endIsOnTheDisk() throws IOException {
    FailingDisk disk = new FailingDisk(100);
    try (GrowingFile growing = GrowingFile.create(disk, file())) {
      write(growing, "all");
    }
    assertEquals(List.of("create", "write", "rename", "sync", "sync folder"), disk.steps());
  }
}
