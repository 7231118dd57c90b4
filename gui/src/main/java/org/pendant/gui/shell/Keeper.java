package org.pendant.gui.shell;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.gui.session.DiskChange;
import org.pendant.gui.session.ProgramDocument;
import org.pendant.gui.session.ProgramFile;
import org.pendant.gui.session.Programs;
import org.pendant.gui.session.RecoveryFolder;
import org.pendant.gui.shell.Notices.Choice;

/**
 * Looks after the open programs: keeps what is not saved against a crash, and notices what others
 * change on disk.
 */
final class Keeper {
  private final Programs programs;
  private final RecoveryFolder recovery;
  private final Notices notices;
  private final Consumer<String> tell;
  private final IdentityHashMap<ProgramDocument, Kept> kept = new IdentityHashMap<>();
  private final IdentityHashMap<ProgramDocument, DiskChange> watched = new IdentityHashMap<>();
  private boolean busy;

  /** What was kept of a program, and under which name. */
  private record Kept(ProgramDocument document, Optional<Path> file, String text) {}

  Keeper(Programs programs, RecoveryFolder recovery, Notices notices, Consumer<String> tell) {
    this.programs = programs;
    this.recovery = recovery;
    this.notices = notices;
    this.tell = tell;
  }

  /** Offers what was left behind by a Pendant that did not end properly. */
  void offerLeftBehind() {
    Background.run(
        recovery::leftBehind,
        found -> found.forEach(this::offer),
        failed -> tell.accept("Unsaved texts cannot be read: " + failed.getMessage()));
  }

  private void offer(RecoveryFolder.LeftBehind left) {
    String where = left.file().map(Object::toString).orElse(left.name());
    notices.ask(
        "recovery-" + left.kept().getFileName(),
        "Pendant ended before " + where + " was saved.",
        List.of(
            new Choice("Restore", () -> restore(left)), new Choice("Discard", () -> forget(left))));
  }

  private void restore(RecoveryFolder.LeftBehind left) {
    Background.run(
        () -> left.file().isPresent() ? document(left) : untitled(left),
        document -> {
          programs.select(document);
          document.setText(left.text());
          forget(left);
        },
        failed -> tell.accept("Not restored: " + failed.getMessage()));
  }

  private static ProgramDocument document(RecoveryFolder.LeftBehind left) throws IOException {
    Path file = left.file().orElseThrow();
    return Files.exists(file)
        ? ProgramDocument.of(ProgramFile.read(file))
        : ProgramDocument.of(ProgramFile.create(file, ""));
  }

  private static ProgramDocument untitled(RecoveryFolder.LeftBehind left) {
    return ProgramDocument.untitled(left.name(), "");
  }

  private void forget(RecoveryFolder.LeftBehind left) {
    work(() -> recovery.forget(left));
  }

  /** Looks at all open programs; called every few seconds. */
  void look() {
    if (busy) {
      return;
    }
    List<IoAction> work = new ArrayList<>();
    for (ProgramDocument each : programs.all()) {
      keep(each, work);
      watch(each, work);
    }
    kept.keySet().stream()
        .filter(each -> !programs.all().contains(each))
        .toList()
        .forEach(closed -> drop(closed, work));
    if (!work.isEmpty()) {
      busy = true;
      work(
          () -> {
            for (IoAction each : work) {
              each.run();
            }
          });
    }
  }

  private void keep(ProgramDocument document, List<IoAction> work) {
    Kept before = kept.get(document);
    if (!document.modified()) {
      drop(document, work);
      return;
    }
    Kept now = new Kept(document, document.file(), document.text());
    if (!now.equals(before)) {
      kept.put(document, now);
      String name = document.name();
      work.add(() -> recovery.keep(now.file(), name, now.text()));
    }
  }

  private void drop(ProgramDocument document, List<IoAction> work) {
    Kept before = kept.remove(document);
    if (before != null) {
      String name = document.name();
      work.add(() -> recovery.forget(before.file(), name));
    }
  }

  private void watch(ProgramDocument document, List<IoAction> work) {
    Optional<ProgramFile> known = document.onDisk();
    if (known.isEmpty()) {
      return;
    }
    DiskChange change = watched.computeIfAbsent(document, d -> new DiskChange());
    work.add(
        () ->
            change
                .look(known.get())
                .ifPresent(now -> EventQueue.invokeLater(() -> changed(document, known, now))));
  }

  private void changed(ProgramDocument document, Optional<ProgramFile> known, ProgramFile now) {
    if (!document.onDisk().equals(known)) {
      // It was saved or read again meanwhile.
      return;
    }
    if (!document.modified()) {
      document.reloaded(now);
      tell.accept(document.name() + " has changed on disk and was read again");
      return;
    }
    notices.ask(
        "disk-change",
        document.name() + " has changed on disk, and here too.",
        List.of(
            new Choice("Read it again", () -> document.reloaded(now)),
            new Choice("Keep mine", () -> {})));
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
        tell.accept("Not removed: " + e.getMessage());
      }
    }
  }

  /** Something that reads or writes. */
  @FunctionalInterface
  private interface IoAction {
    void run() throws IOException;
  }

  private void work(IoAction action) {
    Background.run(
        () -> {
          action.run();
          return true;
        },
        done -> busy = false,
        failed -> {
          busy = false;
          tell.accept("Unsaved texts cannot be kept: " + failed.getMessage());
        });
  }
}
