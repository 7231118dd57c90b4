package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.function.Consumer;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.shell.Notices.Choice;

/** Close dialog: asks about unsaved work before the window closes. */
final class CloseDialog {
  private static final String QUESTION = "unsaved";
  private static final String WAITING = "saving";

  private final Programs programs;
  private final ProgramFiles files;
  private final ActiveInstallation installation;
  private final InstallationFiles installationFiles;
  private final SceneDraft scene;
  private final SceneFiles sceneFiles;
  private final SaveQueue saves;
  private final Notices notices;
  private final Runnable leave;
  private boolean waiting;

  /**
   * The way out.
   *
   * @param leave closes the window
   */
  CloseDialog(
      Programs programs,
      ProgramFiles files,
      ActiveInstallation installation,
      InstallationFiles installationFiles,
      SceneDraft scene,
      SceneFiles sceneFiles,
      SaveQueue saves,
      Notices notices,
      Runnable leave) {
    this.programs = programs;
    this.files = files;
    this.installation = installation;
    this.installationFiles = installationFiles;
    this.scene = scene;
    this.sceneFiles = sceneFiles;
    this.saves = saves;
    this.notices = notices;
    this.leave = leave;
  }

  /** Leaves, after what is being saved is on disk and people were asked for the rest. */
  void ask() {
    if (waiting) {
      return;
    }
    if (!saves.underWay().isEmpty()) {
      await();
      return;
    }
    List<ProgramDocument> unsaved = unsaved();
    if (unsaved.isEmpty()) {
      leave.run();
      return;
    }
    String names = String.join(", ", unsaved.stream().map(ProgramDocument::name).toList());
    notices.ask(
        QUESTION,
        text("notSaved", names),
        List.of(
            unsaved.size() == 1
                ? new Choice("save", text("save"), this::saveAndLeave)
                : new Choice("save-all", text("saveAll"), this::saveAndLeave),
            new Choice("quit-without-saving", text("quitWithoutSaving"), leave),
            Choice.nothing("cancel", text("cancel"))));
    notices.focus();
  }

  /** A disk that answers no more holds nobody: the old file stays whole then. */
  private void await() {
    waiting = true;
    List<String> names =
        saves.underWay().stream().map(file -> String.valueOf(file.getFileName())).toList();
    notices.ask(
        WAITING,
        text("savingTheWindowClosesWhenThat", String.join(", ", names)),
        List.of(
            new Choice("stay", text("stay"), () -> waiting = false, true),
            new Choice("quit-without-saving", text("quitWithoutSaving"), leave)));
    saves.whenDone(this::saved);
  }

  private void saved() {
    if (waiting) {
      waiting = false;
      notices.close(WAITING);
      // What could not be saved is asked about.
      ask();
    }
  }

  private List<ProgramDocument> unsaved() {
    List<ProgramDocument> all = new ArrayList<>(programs.all());
    all.add(installation.document());
    all.add(scene.document());
    all.removeIf(each -> !each.modified());
    return all;
  }

  private void saveAndLeave() {
    saveNext(unsaved().iterator());
  }

  /** One after the other: each may ask where. What is not saved keeps the window open. */
  private void saveNext(Iterator<ProgramDocument> left) {
    if (!left.hasNext()) {
      // The user may have continued writing meanwhile.
      ask();
      return;
    }
    ProgramDocument next = left.next();
    Consumer<Boolean> then =
        saved -> {
          if (saved) {
            saveNext(left);
          }
        };
    if (next == installation.document()) {
      installationFiles.save(then);
    } else if (next == scene.document()) {
      sceneFiles.save(then);
    } else {
      programs.select(next);
      files.save(next, then);
    }
  }
}
