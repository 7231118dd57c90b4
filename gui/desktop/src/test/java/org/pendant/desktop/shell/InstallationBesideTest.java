package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.text.ProgramText;

/** Programs that are made for an installation beside them. */
@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class InstallationBesideTest {
  private static final String NOTICE = "installation-beside";

  @TempDir Path folder;

  private final Notices notices = new Notices();
  private final ActiveInstallation active = new ActiveInstallation();
  private ProgramDocument weld;
  private ProgramDocument glue;
  private ProgramDocument script;
  private Programs programs;
  private InstallationFiles files;

  @BeforeEach
  void openAll() throws Exception {
    weld = madeFor("weld");
    glue = madeFor("glue");
    Path file = folder.resolve("plain.script");
    Files.writeString(file, "x = 1\n");
    script = ProgramDocument.of(SavedProgram.read(file));
    programs = new Programs(script);
    files =
        new InstallationFiles(
            active,
            new DocumentSaver(new SaveQueue(), notices, text -> {}, text -> {}),
            new MemorySettings(),
            notices,
            text -> {},
            text -> {},
            new UsedFolder(),
            notices);
    DispatchThread.run(() -> files.offerBeside(programs));
  }

  private ProgramDocument madeFor(String name) throws IOException {
    String installation = name + "_cell.pinst";
    Files.writeString(folder.resolve(installation), InstallationText.write(Installation.NONE));
    Path file = folder.resolve(name + ".pendant");
    Files.writeString(file, ProgramText.write(ProgramTree.empty().withInstallation(installation)));
    return ProgramDocument.of(SavedProgram.read(file));
  }

  private void select(ProgramDocument program) throws Exception {
    DispatchThread.run(() -> programs.select(program));
  }

  private void awaitOffer(String installation) throws Exception {
    DispatchThread.await(() -> words(notices).anyMatch(each -> each.contains(installation)));
  }

  @Test
  void whatIsOfferedGoesWithItsProgramAndComesBackWithIt() throws Exception {
    select(weld);
    awaitOffer("weld_cell.pinst");
    select(script);
    assertFalse(notices.shows(NOTICE));
    select(weld);
    awaitOffer("weld_cell.pinst");
  }

  @Test
  void theDialogForAnotherOneBeginsBesideTheProgram() throws Exception {
    select(weld);
    DispatchThread.run(() -> assertEquals(folder, files.folder()));
  }

  @Test
  void whatIsFoundTooLateIsNotOfferedForAnotherProgram() throws Exception {
    for (int i = 0; i < 20; i++) {
      DispatchThread.run(
          () -> {
            programs.select(weld);
            programs.select(glue);
          });
      awaitOffer("glue_cell.pinst");
      select(script);
      assertFalse(notices.shows(NOTICE));
    }
    select(glue);
    awaitOffer("glue_cell.pinst");
    assertTrue(words(notices).noneMatch(each -> each.contains("weld_cell.pinst")));
  }

  @Test
  void whoKeepsTheInstallationIsNotAskedAgain() throws Exception {
    select(weld);
    awaitOffer("weld_cell.pinst");
    DispatchThread.run(() -> button(notices).orElseThrow().doClick());
    DispatchThread.run(() -> assertFalse(notices.shows(NOTICE)));
    select(glue);
    awaitOffer("glue_cell.pinst");
    select(weld);
    assertFalse(notices.shows(NOTICE));
    select(glue);
    awaitOffer("glue_cell.pinst");
  }

  @Test
  void theOfferGoesWhenThatInstallationIsOpenedByAnotherWay() throws Exception {
    select(weld);
    awaitOffer("weld_cell.pinst");
    SavedProgram other = SavedProgram.read(folder.resolve("glue_cell.pinst"));
    DispatchThread.run(() -> active.open(ProgramDocument.of(other)));
    DispatchThread.run(() -> assertTrue(notices.shows(NOTICE)));
    SavedProgram named = SavedProgram.read(folder.resolve("weld_cell.pinst"));
    DispatchThread.run(() -> active.open(ProgramDocument.of(named)));
    DispatchThread.run(() -> assertFalse(notices.shows(NOTICE)));
  }

  private static Stream<String> words(Component in) {
    Stream<String> own =
        in instanceof JTextComponent text ? Stream.of(text.getText()) : Stream.empty();
    return in instanceof Container inner
        ? Stream.concat(
            own, Stream.of(inner.getComponents()).flatMap(InstallationBesideTest::words))
        : own;
  }

  private static Optional<AbstractButton> button(Component in) {
    if (in instanceof AbstractButton button && button.getText().equals("Keep this one")) {
      return Optional.of(button);
    }
    return in instanceof Container inner
        ? Stream.of(inner.getComponents()).flatMap(each -> button(each).stream()).findFirst()
        : Optional.empty();
  }
}
