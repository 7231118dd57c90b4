package org.pendant.protocols.interpreter;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.pendant.protocols.teachpendant.InterpreterFiles;
import org.pendant.script.vm.InterpreterEvent;

/**
 * Log files of interpreter mode (manual 13.8): what is interpreted now, what was cleared last, and
 * what programs keep.
 */
final class LogFiles {
  /** What programs keep is begun anew beyond this: no program can fill the disk. */
  private static final long MAX_BYTES = 16 << 20;

  private final Path folder;
  private String program = "";

  /** Whether the current file belongs to the present program. */
  private boolean begun;

  LogFiles(Path folder) {
    this.folder = folder;
  }

  /** Writes what has happened. */
  void write(InterpreterEvent event) throws IOException {
    switch (event) {
      case InterpreterEvent.ProgramStarted started -> {
        program = started.program();
        begun = false;
      }
      case InterpreterEvent.Accepted accepted -> add(accepted);
      case InterpreterEvent.Cleared _ -> moveAway();
      case InterpreterEvent.Kept _ -> keep();
    }
  }

  private Path current() {
    return folder.resolve(InterpreterFiles.CURRENT);
  }

  private void add(InterpreterEvent.Accepted accepted) throws IOException {
    if (!begun) {
      begin();
    }
    append(
        current(),
        "e: " + accepted.executed() + " c: " + accepted.id() + " : " + accepted.text() + "\n");
  }

  private void begin() throws IOException {
    Files.createDirectories(folder);
    Files.deleteIfExists(current());
    append(
        current(),
        "log of interpreter mode, program "
            + program
            + ", begun "
            + Instant.now().truncatedTo(ChronoUnit.SECONDS)
            + "\n");
    begun = true;
  }

  private void moveAway() throws IOException {
    if (begun) {
      begun = false;
      Files.move(
          current(), folder.resolve(InterpreterFiles.LAST), StandardCopyOption.REPLACE_EXISTING);
    }
  }

  private void keep() throws IOException {
    if (!begun) {
      return;
    }
    begun = false;
    Path saved = folder.resolve(InterpreterFiles.SAVED);
    byte[] statements = Files.readAllBytes(current());
    if (Files.exists(saved) && Files.size(saved) + statements.length > MAX_BYTES) {
      Files.delete(saved);
    }
    Files.write(saved, statements, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
    Files.delete(current());
  }

  private static void append(Path file, String text) throws IOException {
    Files.write(
        file,
        text.getBytes(StandardCharsets.ISO_8859_1),
        StandardOpenOption.CREATE,
        StandardOpenOption.APPEND);
  }
}
