package org.pendant.protocols.interpreter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.script.vm.InterpreterEvent;

class LogFilesTest {
  @TempDir Path folder;

  private LogFiles files;

  @BeforeEach
  void begin() throws IOException {
    files = new LogFiles(folder.resolve("logs"));
    files.write(new InterpreterEvent.ProgramStarted("prog"));
  }

  private void accept(int id, String text) throws IOException {
    files.write(new InterpreterEvent.Accepted(id, id - 1, text));
  }

  /** The statements in a file, without the lines about when it was begun. */
  private List<String> statements(String name) throws IOException {
    return Files.readAllLines(folder.resolve("logs").resolve(name)).stream()
        .filter(line -> line.startsWith("e: "))
        .toList();
  }

  private boolean exists(String name) {
    return Files.exists(folder.resolve("logs").resolve(name));
  }

  @Test
  void nothingIsWrittenWithoutStatements() throws IOException {
    files.write(new InterpreterEvent.Cleared());
    files.write(new InterpreterEvent.Kept());
    assertFalse(Files.exists(folder.resolve("logs")));
  }

  @Test
  void statementsGoToTheCurrentFile() throws IOException {
    accept(1, "a = 1");
    accept(2, "b = 2");
    assertEquals(List.of("e: 0 c: 1 : a = 1", "e: 1 c: 2 : b = 2"), statements("interpreter.log"));
  }

  @Test
  void clearingMovesThemAwayOverWhatWasThere() throws IOException {
    accept(1, "a = 1");
    files.write(new InterpreterEvent.Cleared());
    assertFalse(exists("interpreter.log"));
    accept(2, "b = 2");
    files.write(new InterpreterEvent.Cleared());
    assertEquals(List.of("e: 1 c: 2 : b = 2"), statements("interpreter.0.log"));
  }

  @Test
  void whatAProgramKeepsIsCollected() throws IOException {
    accept(1, "a = 1");
    files.write(new InterpreterEvent.Kept());
    accept(2, "b = 2");
    files.write(new InterpreterEvent.Kept());
    assertFalse(exists("interpreter.log"));
    assertEquals(
        List.of("e: 0 c: 1 : a = 1", "e: 1 c: 2 : b = 2"), statements("interpreter.saved.log"));
  }

  @Test
  void anotherProgramBeginsAnew() throws IOException {
    accept(1, "a = 1");
    files.write(new InterpreterEvent.ProgramStarted("other"));
    assertEquals(List.of("e: 0 c: 1 : a = 1"), statements("interpreter.log"));
    accept(1, "b = 2");
    assertEquals(List.of("e: 0 c: 1 : b = 2"), statements("interpreter.log"));
  }

  @Test
  void aFolderThatCannotBeMadeIsTold() throws IOException {
    Files.writeString(folder.resolve("logs"), "in the way");
    assertThrows(IOException.class, () -> accept(1, "a = 1"));
  }
}
