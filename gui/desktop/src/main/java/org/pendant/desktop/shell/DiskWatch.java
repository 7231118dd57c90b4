package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.io.IOException;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.DiskChange;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.kit.background.Background;

/** Disk watch: notices what others do to the files of the open programs and the installation. */
final class DiskWatch {
  private final Programs programs;
  private final ActiveInstallation installation;
  private final SaveQueue saves;
  private final Notices notices;
  private final Consumer<String> tell;
  private final IdentityHashMap<ProgramDocument, DiskChange> watched = new IdentityHashMap<>();
  private boolean busy;

  /** A program and its file, as they were when the look began. */
  private record Watched(ProgramDocument document, SavedProgram known, DiskChange change) {}

  /** What has become of a file. */
  private sealed interface Found {
    Watched watched();

    /** It says something else, or is back. */
    record Other(Watched watched, SavedProgram now) implements Found {}

    /** It is there no more. */
    record Gone(Watched watched) implements Found {}

    /** It cannot be read any more. */
    record Unreadable(Watched watched, String why) implements Found {}
  }

  DiskWatch(
      Programs programs,
      ActiveInstallation installation,
      SaveQueue saves,
      Notices notices,
      Consumer<String> tell) {
    this.programs = programs;
    this.installation = installation;
    this.saves = saves;
    this.notices = notices;
    this.tell = tell;
  }

  /** Looks at the files of all that is open; called every few seconds. */
  void look() {
    List<ProgramDocument> all = new ArrayList<>(programs.all());
    all.add(installation.document());
    watched.keySet().removeIf(each -> !all.contains(each));
    List<Watched> files = new ArrayList<>();
    for (ProgramDocument each : all) {
      each.onDisk()
          .filter(known -> !saves.writes(known.path()))
          .ifPresent(
              known ->
                  files.add(
                      new Watched(
                          each, known, watched.computeIfAbsent(each, d -> new DiskChange()))));
    }
    if (busy || files.isEmpty()) {
      return;
    }
    busy = true;
    Background.run(
        () -> files.stream().flatMap(each -> found(each).stream()).toList(),
        found -> {
          busy = false;
          found.stream().filter(this::stillSo).forEach(this::tell);
        },
        // Each file has its own trouble: this is a fault, which is told elsewhere.
        failed -> busy = false);
  }

  private static Optional<Found> found(Watched file) {
    if (file.change().gone(file.known())) {
      return Optional.of(new Found.Gone(file));
    }
    try {
      return file.change().look(file.known()).map(now -> new Found.Other(file, now));
    } catch (IOException e) {
      return Optional.of(new Found.Unreadable(file, e.getMessage()));
    }
  }

  /** Whether the program was neither saved nor read again meanwhile, and is not being saved. */
  private boolean stillSo(Found found) {
    Watched file = found.watched();
    if (saves.writes(file.known().path())) {
      // It may be what we write ourselves: the next look begins anew.
      watched.remove(file.document());
      return false;
    }
    return file.document().onDisk().equals(Optional.of(file.known()));
  }

  private void tell(Found found) {
    ProgramDocument document = found.watched().document();
    switch (found) {
      case Found.Gone gone -> {
        if (document.readOnly()) {
          tell.accept(text("isOnDiskNoMoreA", document.name()));
        } else {
          document.gone();
          tell.accept(text("isOnDiskNoMoreSaving", document.name()));
        }
      }
      case Found.Unreadable(Watched file, String why) ->
          tell.accept(text("whatHasChangedOnDiskCannot", why));
      case Found.Other(Watched file, SavedProgram now) -> changed(document, now);
    }
  }

  private void changed(ProgramDocument document, SavedProgram now) {
    if (document.text().equals(now.text())) {
      document.saved(now);
    } else if (document.modified()) {
      ask(document, now);
    } else {
      document.reloaded(now);
      tell.accept(text("hasChangedOnDiskAndWas", document.name()));
    }
  }

  /** Name of the question what becomes of a file that has changed here and on disk. */
  static String question(ProgramDocument document) {
    return "disk-change-" + System.identityHashCode(document);
  }

  private void ask(ProgramDocument document, SavedProgram now) {
    if (notices.shows(DocumentSaver.question(document))) {
      // One question at a time: the next look begins anew.
      watched.remove(document);
      return;
    }
    String name = question(document);
    notices.ask(
        name,
        text("hasChangedOnDiskAndHere", document.name()),
        List.of(
            new Choice("read-it-again", text("readItAgain"), () -> document.reloaded(now)),
            new Choice("keep-mine", text("keepMine"), () -> document.changedOnDisk(now), true)));
    document.addListener(
        new ProgramDocument.Listener() {
          @Override
          public void fileChanged() {
            if (!document.modified()) {
              // Saved, or read again some other way: there is nothing to choose any more.
              document.removeListener(this);
              notices.close(name);
            }
          }
        });
  }
}
