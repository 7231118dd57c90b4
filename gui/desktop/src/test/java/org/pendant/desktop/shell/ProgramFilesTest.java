package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
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

  /** Files of {@code programs}; for the dispatch thread. */
  private ProgramFiles files(Programs programs, List<String> told) {
    Notices notices = new Notices();
    DocumentSaver saver = new DocumentSaver(new SaveQueue(), notices, told::add, told::add);
    return new ProgramFiles(
        programs, saver, settings, notices, told::add, told::add, new UsedFolder(), notices);
  }

  @Test
  void severalFilesComeInTheOrderInWhichTheyAreOpened() throws Exception {
    List<Path> wanted = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      // the first ones take longest to read
      String text = "x = 0\n".repeat(1 + (12 - i) * 4000);
      wanted.add(Files.writeString(folder.resolve("program_" + i + ".script"), text));
    }
    wanted.add(5, folder.resolve("missing.script"));
    Programs[] programs = {null};
    List<String> told = new ArrayList<>();
    CountDownLatch all = new CountDownLatch(12);
    DispatchThread.run(
        () -> {
          programs[0] = new Programs(ProgramDocument.untitled("untitled.script", ""));
          ProgramFiles files = files(programs[0], told);
          files.showBy(shown -> all.countDown());
          wanted.forEach(files::open);
        });
    assertTrue(all.await(30, TimeUnit.SECONDS));
    DispatchThread.run(
        () -> {
          wanted.remove(5);
          assertEquals(
              wanted, programs[0].all().stream().map(each -> each.file().orElseThrow()).toList());
          assertEquals(Optional.of(wanted.getLast()), programs[0].current().file());
          assertEquals(1, told.size(), told::toString);
        });
  }

  @Test
  void nextStartShowsTheProgramThatWasInFrontNotTheOneThatWasOpenedLast() throws Exception {
    ProgramDocument first = program("first.script");
    ProgramDocument second = program("second.script");
    List<String> told = new ArrayList<>();
    DispatchThread.run(
        () -> {
          Programs programs = new Programs(first);
          var _ = files(programs, told);
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
