package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.session.SceneMemory;
import org.pendant.kit.settings.MemorySettings;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
@Tag("slow")
final class DocumentSaverTest {
  private static final int SAVES = 200;

  @TempDir Path folder;

  private final SaveQueue queue = new SaveQueue();
  private final Notices notices = new Notices();
  private final List<String> told = new ArrayList<>();
  private final List<String> warned = new ArrayList<>();
  private final List<Boolean> saved = new ArrayList<>();
  private final DocumentSaver saver = new DocumentSaver(queue, notices, told::add, warned::add);
  private Path file;
  private ProgramDocument document;

  @BeforeEach
  void openFile() throws IOException {
    file = folder.resolve("a.script");
    Files.writeString(file, "x = 0\r\n");
    document = ProgramDocument.of(SavedProgram.read(file));
  }

  @Test
  void ofSavesInARowTheLastTextStays() throws Exception {
    DispatchThread.run(
        () -> {
          for (int i = 1; i <= SAVES; i++) {
            document.setText("x = " + i + "\n");
            saver.save(document, saved::add);
          }
        });
    DispatchThread.await(() -> saved.size() == SAVES);
    assertEquals("x = " + SAVES + "\r\n", Files.readString(file));
    assertFalse(document.modified());
    assertEquals(List.of(), warned);
  }

  @Test
  void itSaysSavedOnlyWhenTheTextIsOnDisk() throws Exception {
    DispatchThread.run(
        () -> {
          document.setText("x = 1\n");
          saver.save(document, saved::add);
          assertEquals(List.of(), told);
          assertTrue(document.modified());
        });
    DispatchThread.await(() -> !told.isEmpty());
    assertEquals(List.of("Saved " + file), told);
    assertEquals("x = 1\r\n", Files.readString(file));
  }

  @Test
  void whatOthersHaveWrittenIsNotReplacedWithoutAQuestion() throws Exception {
    Files.writeString(file, "theirs = 1\n");
    change("mine = 1\n");
    DispatchThread.await(notices::any);
    assertEquals("theirs = 1\n", Files.readString(file));
    assertEquals(List.of(), told);
    choose("Cancel");
    DispatchThread.await(() -> saved.equals(List.of(false)));
    assertTrue(document.modified());
  }

  @Test
  void whoeverWantsToReplacesIt() throws Exception {
    Files.writeString(file, "theirs = 1\n");
    change("mine = 1\n");
    DispatchThread.await(notices::any);
    choose("Replace it");
    DispatchThread.await(() -> saved.equals(List.of(true)));
    assertEquals("mine = 1\r\n", Files.readString(file));
  }

  @Test
  void whoeverWantsToReadsItAgain() throws Exception {
    Files.writeString(file, "theirs = 1\n");
    change("mine = 1\n");
    DispatchThread.await(notices::any);
    choose("Read it again");
    DispatchThread.await(() -> saved.equals(List.of(false)));
    assertEquals("theirs = 1\n", document.text());
    assertFalse(document.modified());
  }

  @Test
  void anAnswerHoldsForWhatWasSeenOnly() throws Exception {
    Files.writeString(file, "theirs = 1\n");
    change("mine = 1\n");
    DispatchThread.await(notices::any);
    Files.writeString(file, "theirs = 2\n");
    choose("Replace it");
    DispatchThread.await(notices::any);
    assertEquals("theirs = 2\n", Files.readString(file));
  }

  @Test
  void aFileThatIsGoneIsWrittenAgain() throws Exception {
    Files.delete(file);
    change("mine = 1\n");
    DispatchThread.await(() -> saved.equals(List.of(true)));
    assertEquals("mine = 1\r\n", Files.readString(file));
  }

  @Test
  void whatCannotBeReadAnyMoreIsNotReplaced() throws Exception {
    Files.write(file, new byte[] {1, 0, 2});
    change("mine = 1\n");
    DispatchThread.await(() -> saved.equals(List.of(false)));
    assertTrue(warned.getFirst().contains("it is no text, byte 2 is 0"), warned::toString);
    assertEquals(3, Files.size(file));
  }

  @Test
  void aProgramOfPolyScopeXIsNotSavedButOffersCopies() throws Exception {
    Path foreign = file.resolveSibling("pick.urpx");
    String json =
        "{\"application\": {\"urscript\": {\"script\": \"\"}}, \"program\":"
            + " {\"programContent\": {}, \"urscript\": {\"script\": \"x = 1\"}}}";
    Files.writeString(foreign, json);
    ProgramDocument read = ProgramDocument.of(SavedProgram.read(foreign));
    DispatchThread.run(
        () ->
            new ProgramFiles(
                    new Programs(read),
                    saver,
                    new MemorySettings(),
                    notices,
                    told::add,
                    warned::add,
                    new UsedFolder(),
                    notices)
                .save(read, saved::add));
    assertEquals(List.of(false), saved);
    assertEquals(json, Files.readString(foreign));
    for (String each :
        List.of("Save a copy as program\u2026", "Save a copy as script\u2026", "Close")) {
      assertTrue(button(notices, each).isPresent(), each);
    }
    choose("Close");
    assertFalse(notices.any());
  }

  @Test
  void theWindowClosesAfterWhatIsBeingSavedIsOnDisk() throws Exception {
    List<String> left = new ArrayList<>();
    CloseDialog closeDialog = leaving(left);
    DispatchThread.run(
        () -> {
          document.setText("mine = 1\n");
          saver.save(document, saved::add);
          closeDialog.ask();
          assertEquals(List.of(), left);
        });
    DispatchThread.await(() -> !left.isEmpty());
    assertEquals(List.of("mine = 1\r\n"), left);
  }

  @Test
  void theWindowStaysWhenASaveFailsOnTheWayOut() throws Exception {
    List<String> left = new ArrayList<>();
    CloseDialog closeDialog = leaving(left);
    Files.write(file, new byte[] {1, 0, 2});
    DispatchThread.run(
        () -> {
          document.setText("mine = 1\n");
          saver.save(document, saved::add);
          closeDialog.ask();
        });
    DispatchThread.await(() -> button(notices, "Quit without saving").isPresent());
    DispatchThread.await(() -> saved.equals(List.of(false)));
    assertEquals(List.of(), left);
    assertTrue(notices.any());
  }

  /** Notes what is on disk when the window closes. */
  private CloseDialog leaving(List<String> left) {
    Programs programs = new Programs(document);
    ActiveInstallation installation = new ActiveInstallation();
    SceneDraft scene = new SceneDraft();
    return new CloseDialog(
        programs,
        new ProgramFiles(
            programs,
            saver,
            new MemorySettings(),
            notices,
            told::add,
            warned::add,
            new UsedFolder(),
            notices),
        installation,
        new InstallationFiles(
            installation,
            saver,
            new MemorySettings(),
            notices,
            told::add,
            warned::add,
            new UsedFolder(),
            notices),
        scene,
        new SceneFiles(
            installation,
            scene,
            saver,
            new SceneMemory(new MemorySettings()),
            notices,
            told::add,
            new UsedFolder(),
            notices,
            (wanted, then) -> then.run()),
        queue,
        notices,
        () -> left.add(text()));
  }

  private String text() {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return e.toString();
    }
  }

  private void change(String text) throws Exception {
    DispatchThread.run(
        () -> {
          document.setText(text);
          saver.save(document, saved::add);
        });
  }

  private void choose(String text) throws Exception {
    DispatchThread.run(() -> button(notices, text).orElseThrow().doClick());
  }

  private static Optional<AbstractButton> button(Container in, String text) {
    for (Component each : in.getComponents()) {
      if (each instanceof AbstractButton button && button.getText().equals(text)) {
        return Optional.of(button);
      }
      if (each instanceof Container inner) {
        Optional<AbstractButton> found = button(inner, text);
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return Optional.empty();
  }
}
