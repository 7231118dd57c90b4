package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;

/** Which programs a window remembers for its next start. */
final class ProgramFilesTest {
  /** Settings in memory. */
  private final Settings settings = new MemorySettings();

  @TempDir private Path folder;

  private ProgramDocument program(String name) throws IOException {
    Path file = Files.writeString(folder.resolve(name), "x = 0\n");
    return ProgramDocument.of(SavedProgram.read(file));
  }

  @Test
  void nextStartShowsTheProgramThatWasInFrontNotTheOneThatWasOpenedLast() throws Exception {
    ProgramDocument first = program("first.script");
    ProgramDocument second = program("second.script");
    List<String> told = new ArrayList<>();
    DispatchThread.run(
        () -> {
          Programs programs = new Programs(first);
          Notices notices = new Notices();
          DocumentSaver saver = new DocumentSaver(new SaveQueue(), notices, told::add, told::add);
          var _ =
              new ProgramFiles(
                  programs,
                  saver,
                  settings,
                  notices,
                  told::add,
                  told::add,
                  new UsedFolder(),
                  notices);
          programs.select(second);
          programs.select(first);
        });

    assertEquals(
        List.of(folder.resolve("first.script"), folder.resolve("second.script")),
        ProgramFiles.openLastTime(settings));
    assertEquals(
        Optional.of(folder.resolve("first.script")), ProgramFiles.inFrontLastTime(settings));
  }

  @Test
  void withoutThatItIsTheOneThatWasOpenedLast() {
    settings.put("file.recent", "/programs/b.script\n/programs/a.script");

    assertEquals(
        Optional.of(Path.of("/programs/b.script")), ProgramFiles.inFrontLastTime(settings));
  }
}
