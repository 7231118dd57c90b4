package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.OpenFiles;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SavedProgram;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class OtherWindowsTest {
  @TempDir Path folder;

  private Path file;
  private Window first;
  private Window second;

  /** What a window has of it. */
  private static final class Window {
    final List<String> told = new ArrayList<>();
    final Notices notices = new Notices();
    final Programs programs;
    final OtherWindows others;

    Window(ProgramDocument open, Path folder) {
      programs = new Programs(open);
      others =
          new OtherWindows(
              programs, new ActiveInstallation(), new OpenFiles(folder), notices, told::add);
    }
  }

  @BeforeEach
  void openTwoWindows() throws Exception {
    file = Files.writeString(folder.resolve("a.script"), "x = 1\n");
    SavedProgram read = SavedProgram.read(file);
    first = new Window(ProgramDocument.of(read), folder.resolve("state"));
    second = new Window(ProgramDocument.of(read), folder.resolve("state"));
  }

  /** Nothing is written any more then. */
  @AfterEach
  void closeTheWindows() throws Exception {
    DispatchThread.run(first.others::end);
    DispatchThread.run(second.others::end);
  }

  @Test
  void bothWindowsTellThatTheyHaveTheSameFileOpen() throws Exception {
    look(() -> first.notices.any() && second.notices.any());
  }

  @Test
  void aNoticeThatWasClosedStaysClosedUntilThereIsAnotherFile() throws Exception {
    look(() -> first.notices.any() && second.notices.any());
    DispatchThread.run(() -> first.notices.close("other-window"));
    for (int turn = 0; turn < 20; turn++) {
      DispatchThread.run(first.others::look);
      DispatchThread.run(() -> assertFalse(first.notices.any()));
    }
    Path other = Files.writeString(folder.resolve("b.script"), "y = 1\n");
    DispatchThread.run(() -> first.programs.select(document(other)));
    DispatchThread.run(() -> second.programs.select(document(other)));
    look(() -> first.notices.any());
  }

  @Test
  void theNoticeGoesWhenTheOtherWindowIsClosed() throws Exception {
    look(() -> first.notices.any() && second.notices.any());
    DispatchThread.run(second.others::end);
    DispatchThread.await(
        () -> {
          first.others.look();
          return !first.notices.any();
        });
  }

  @Test
  void whereNothingCanBeToldThatIsSaidOnce() throws Exception {
    Files.writeString(folder.resolve("state"), "a file where the folder should be");
    DispatchThread.await(
        () -> {
          first.others.look();
          return !first.told.isEmpty();
        });
    for (int turn = 0; turn < 20; turn++) {
      DispatchThread.run(first.others::look);
    }
    assertEquals(1, first.told.size());
    assertTrue(first.told.getFirst().contains("cannot be seen"), first.told::toString);
  }

  private static ProgramDocument document(Path file) {
    return ProgramDocument.of(SavedProgram.create(file, "y = 1\n"));
  }

  private void look(BooleanSupplier until) throws Exception {
    DispatchThread.await(
        () -> {
          first.others.look();
          second.others.look();
          return until.getAsBoolean();
        });
  }
}
