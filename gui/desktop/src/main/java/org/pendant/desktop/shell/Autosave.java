package org.pendant.desktop.shell;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.Scene;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RecoveryFolder;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.session.SceneFile;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.kit.background.Background;
import org.pendant.kit.fault.Faults;
import org.pendant.project.installation.text.InstallationText;

/** Autosave: keeps unsaved texts in case of a crash, and offers them at the next start. */
final class Autosave {
  /** So many names of files that were not saved are told in one question. */
  private static final int MAX_NAMES = 3;

  private final Programs programs;
  private final ActiveInstallation installation;
  private final SceneDraft scene;
  private final RecoveryFolder recovery;
  private final Notices notices;
  private final Consumer<String> tell;
  private final IdentityHashMap<ProgramDocument, Kept> kept = new IdentityHashMap<>();
  private boolean busy;
  private boolean troubleTold;
  private int programsKept;

  /**
   * What was kept of a program.
   *
   * @param number of the program
   */
  private record Kept(int number, Optional<Path> file, String text) {}

  /** Something that reads or writes. */
  @FunctionalInterface
  private interface IoAction {
    void run() throws IOException;
  }

  Autosave(
      Programs programs,
      ActiveInstallation installation,
      SceneDraft scene,
      RecoveryFolder recovery,
      Notices notices,
      Consumer<String> tell) {
    this.programs = programs;
    this.installation = installation;
    this.scene = scene;
    this.recovery = recovery;
    this.notices = notices;
    this.tell = tell;
  }

  // --- what was left behind

  /** Offers what was left behind by a Pendant that did not end properly. */
  void offerLeftBehind() {
    Background.run(
        recovery::leftBehind,
        this::offer,
        failed ->
            tell.accept(ShellTexts.text("textsKeptFromTheLastTime", FileTrouble.reason(failed))));
  }

  /** Several are offered together: most people want all of them back. */
  private void offer(List<RecoveryFolder.LeftBehind> found) {
    if (found.size() < 2) {
      found.forEach(this::offer);
      return;
    }
    String names =
        found.stream().limit(MAX_NAMES).map(Autosave::where).collect(Collectors.joining(", "));
    int more = found.size() - MAX_NAMES;
    notices.ask(
        "recovery",
        ShellTexts.text(
            "pendantEndedBeforeFilesWereSaved",
            found.size(),
            more > 0 ? ShellTexts.text("andMore", names, more) : names),
        List.of(
            new Choice(
                "restore-all", ShellTexts.text("restoreAll"), () -> found.forEach(this::restore)),
            new Choice("one-by-one", ShellTexts.text("oneByOne"), () -> found.forEach(this::offer)),
            Choice.nothing("ask-next-time", ShellTexts.text("askNextTime"))));
  }

  private static String where(RecoveryFolder.LeftBehind left) {
    return left.file().map(Object::toString).orElse(left.name());
  }

  private void offer(RecoveryFolder.LeftBehind left) {
    notices.ask(
        "recovery-" + left.kept().getFileName(),
        ShellTexts.text("pendantEndedBeforeWasSaved", where(left)),
        List.of(
            new Choice("restore", ShellTexts.text("restore"), () -> restore(left)),
            new Choice("discard", ShellTexts.text("discard"), () -> forget(left)),
            Choice.nothing("ask-next-time", ShellTexts.text("askNextTime"))));
  }

  private void restore(RecoveryFolder.LeftBehind left) {
    Optional<ProgramDocument> open =
        left.file().flatMap(this::open).filter(program -> !program.modified());
    if (open.isPresent()) {
      restore(left, open.get());
      return;
    }
    Background.run(
        () -> document(left), document -> restore(left, document), this::tellNotRestored);
  }

  /** What is open already of a file. */
  private Optional<ProgramDocument> open(Path file) {
    Optional<Path> wanted = Optional.of(file);
    if (installation.document().file().equals(wanted)) {
      return Optional.of(installation.document());
    }
    return scene.document().file().equals(wanted)
        ? Optional.of(scene.document())
        : programs.of(file);
  }

  private void restore(RecoveryFolder.LeftBehind left, ProgramDocument document) {
    if (document.name().endsWith(InstallationText.ENDING)) {
      document.setText(left.text());
      installation.open(document);
    } else if (SceneFile.hasEnding(Path.of(document.name()))) {
      restoreScene(left, document);
      return;
    } else {
      programs.select(document);
      document.setText(left.text());
    }
    restored(left, document);
  }

  /** Follows the document from now on instead of what was left behind. */
  private void restored(RecoveryFolder.LeftBehind left, ProgramDocument document) {
    List<IoAction> work = new ArrayList<>();
    // Kept anew before the old one goes: there is no moment without it.
    keep(document, work);
    work.add(() -> recovery.forget(left));
    run(work, () -> {});
  }

  /** What cannot be read, as when a mesh is missing, stays where it was left. */
  private void restoreScene(RecoveryFolder.LeftBehind left, ProgramDocument document) {
    if (document.text().isEmpty()) {
      document.setText(SceneFile.NONE.text());
    }
    String saved = document.text();
    MeshFiles meshes =
        document.onDisk().map(file -> MeshFiles.in(file.path().getParent())).orElse(MeshFiles.NONE);
    Background.run(
        () ->
            new ReadScenes(
                SceneFile.of(document.name(), saved, meshes).scene(),
                SceneFile.of(document.name(), left.text(), meshes)),
        read -> {
          scene.restore(document, read.saved(), read.left());
          restored(left, document);
        },
        this::tellNotRestored);
  }

  /** A scene as it was saved, and as it was left behind. */
  private record ReadScenes(Scene saved, SceneFile left) {}

  private void tellNotRestored(IOException failed) {
    notices.tell("not-restored", ShellTexts.text("notRestored", failed.getMessage()));
  }

  /** The program that a text belongs to, as it is on disk. */
  private static ProgramDocument document(RecoveryFolder.LeftBehind left) throws IOException {
    if (left.file().isEmpty()) {
      return ProgramDocument.untitled(left.name(), "");
    }
    Path file = left.file().get();
    return ProgramDocument.of(
        Files.exists(file) ? SavedProgram.read(file) : SavedProgram.create(file, ""));
  }

  private void forget(RecoveryFolder.LeftBehind left) {
    run(List.of(() -> recovery.forget(left)), () -> {});
  }

  // --- keeping

  /** Looks at all open programs; called every few seconds. */
  void look() {
    if (busy) {
      return;
    }
    List<IoAction> work = new ArrayList<>();
    all().forEach(each -> keep(each, work));
    List.copyOf(kept.keySet()).stream()
        .filter(each -> !all().contains(each))
        .forEach(closed -> drop(closed, work));
    if (!work.isEmpty()) {
      busy = true;
      run(work, () -> busy = false);
    }
  }

  private List<ProgramDocument> all() {
    List<ProgramDocument> all = new ArrayList<>(programs.all());
    all.add(installation.document());
    all.add(scene.document());
    return all;
  }

  private void keep(ProgramDocument document, List<IoAction> work) {
    if (!document.modified()) {
      drop(document, work);
      return;
    }
    Kept before = kept.get(document);
    int number = before == null ? programsKept++ : before.number();
    Kept now = new Kept(number, document.file(), document.text());
    if (!now.equals(before)) {
      kept.put(document, now);
      String name = document.name();
      work.add(() -> recovery.keep(number, now.file(), name, now.text()));
    }
  }

  private void drop(ProgramDocument document, List<IoAction> work) {
    Kept before = kept.remove(document);
    if (before != null) {
      work.add(() -> recovery.forget(before.number()));
    }
  }

  /** The window closes: nothing has to be kept any more. */
  void end() {
    List<IoAction> work = new ArrayList<>();
    List.copyOf(kept.keySet()).forEach(each -> drop(each, work));
    for (IoAction each : work) {
      try {
        each.run();
      } catch (IOException e) {
        // It is offered at the next start, which is better than lost.
        tell.accept(ShellTexts.text("notRemoved", FileTrouble.reason(e)));
      }
    }
  }

  /** Does all of the work: what fails of one text does not keep the others from being kept. */
  private static void each(List<IoAction> work) throws IOException {
    Optional<IOException> trouble = Optional.empty();
    for (IoAction each : work) {
      try {
        each.run();
      } catch (IOException e) {
        trouble = Optional.of(e);
      } catch (RuntimeException e) {
        Faults.report(e);
        trouble = Optional.of(new IOException(ShellTexts.text("internalError", e), e));
      }
    }
    if (trouble.isPresent()) {
      throw trouble.get();
    }
  }

  private void run(List<IoAction> work, Runnable then) {
    Background.run(
        () -> {
          each(work);
          return true;
        },
        done -> {
          then.run();
          troubleTold = false;
        },
        failed -> {
          then.run();
          // The next look tries again; saying it once is enough.
          kept.replaceAll((document, before) -> new Kept(before.number(), before.file(), ""));
          if (!troubleTold) {
            troubleTold = true;
            tell.accept(ShellTexts.text("unsavedTextsCannotBeKeptAgainst", failed.getMessage()));
          }
        });
  }
}
