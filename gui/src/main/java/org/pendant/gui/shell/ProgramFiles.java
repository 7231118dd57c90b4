package org.pendant.gui.shell;

import java.awt.Component;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.gui.export.SaveDialog;
import org.pendant.gui.session.ProgramDocument;
import org.pendant.gui.session.ProgramFile;
import org.pendant.gui.session.Programs;
import org.pendant.gui.workbench.Settings;

/** Opens and saves programs. Only the dispatch thread calls it; it reads and writes elsewhere. */
final class ProgramFiles {
  private static final String RECENT = "file.recent";
  private static final int MOST_RECENT = 10;

  private final Programs programs;
  private final Settings settings;
  private final Consumer<String> tell;
  private final Component parent;
  private int untitled = 1;

  ProgramFiles(Programs programs, Settings settings, Consumer<String> tell, Component parent) {
    this.programs = programs;
    this.settings = settings;
    this.tell = tell;
    this.parent = parent;
  }

  /** A new program with a frame to fill. */
  void create() {
    String name = "untitled" + (untitled == 1 ? "" : untitled);
    untitled++;
    programs.select(ProgramDocument.untitled(name + ".script", "def " + name + "():\n  \nend\n"));
  }

  /** Asks for a file and opens it. */
  void open() {
    OpenDialog.show(parent, folder(), this::open);
  }

  private Optional<Path> folder() {
    return programs.current().file().map(Path::getParent);
  }

  /** Opens a file, or selects it if it is open. */
  void open(Path file) {
    Optional<ProgramDocument> already = programs.of(file);
    if (already.isPresent()) {
      programs.select(already.get());
      return;
    }
    Background.run(
        () -> ProgramFile.read(file),
        read -> {
          ProgramDocument before = programs.current();
          programs.select(ProgramDocument.of(read));
          if (before.file().isEmpty() && !before.modified()) {
            // The example, or a new program that nobody has touched.
            programs.close(before, before);
          }
          remember(file);
        },
        failed -> tell.accept("Not opened: " + failed.getMessage()));
  }

  /** Saves a program where it is, or asks where. */
  void save(ProgramDocument document) {
    Optional<ProgramFile> file = document.toSave();
    if (file.isEmpty()) {
      saveAs(document);
      return;
    }
    Background.run(
        () -> {
          file.get().write();
          return file.get();
        },
        written -> saved(document, written),
        failed -> tell.accept("Not saved: " + failed.getMessage()));
  }

  /** Asks where to save a program. */
  void saveAs(ProgramDocument document) {
    String text = document.text();
    SaveDialog.open(
        parent,
        "Save program as",
        document.name(),
        new String[] {"script"},
        path -> {
          ProgramFile written = ProgramFile.create(path, text);
          written.write();
          EventQueue.invokeLater(() -> saved(document, written));
        },
        tell);
  }

  private void saved(ProgramDocument document, ProgramFile written) {
    document.saved(written);
    remember(written.path());
    tell.accept("Saved " + written.path().toAbsolutePath());
  }

  /** Takes the text from disk again. */
  void reload(ProgramDocument document) {
    document
        .file()
        .ifPresent(
            path ->
                Background.run(
                    () -> ProgramFile.read(path),
                    document::reloaded,
                    failed -> tell.accept("Not read: " + failed.getMessage())));
  }

  private void remember(Path file) {
    String name = file.toAbsolutePath().toString();
    List<String> recent = new ArrayList<>();
    recent.add(name);
    recent().stream().map(Path::toString).filter(each -> !each.equals(name)).forEach(recent::add);
    settings.put(
        RECENT, String.join("\n", recent.subList(0, Math.min(MOST_RECENT, recent.size()))));
  }

  /** The files that were open lately, the last one first. */
  List<Path> recent() {
    return recent(settings);
  }

  /** As {@link #recent()}. */
  static List<Path> recent(Settings settings) {
    return settings.get(RECENT).orElse("").lines().filter(l -> !l.isBlank()).map(Path::of).toList();
  }
}
