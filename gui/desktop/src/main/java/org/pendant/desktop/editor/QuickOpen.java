package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.ScriptFolder;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.kit.background.WorkQueue;
import org.pendant.language.service.OutlineItem;
import org.pendant.language.source.ByteText;

/** Quick open: opens a script, or a function of the one in front, by a few letters of its name. */
final class QuickOpen {
  private static final int MAX_FILES = 2_000;

  private final ScriptEditor editor;
  private final Programs programs;
  private final WorkQueue worker;

  QuickOpen(ScriptEditor editor, Programs programs, WorkQueue worker) {
    this.editor = editor;
    this.programs = programs;
    this.worker = worker;
  }

  /** Offers the open programs, and then the scripts in their folders. */
  void files() {
    List<QuickPick.Item> items = new ArrayList<>();
    Set<Path> folders = new LinkedHashSet<>();
    Set<Path> open = new LinkedHashSet<>();
    for (ProgramDocument each : programs.all()) {
      Optional<Path> file = each.file().map(path -> path.toAbsolutePath().normalize());
      items.add(
          new QuickPick.Item(
              each.name(),
              file.map(path -> String.valueOf(path.getParent())).orElse(text("notOnDiskYet")),
              () -> {
                programs.select(each);
                editor.current().area().requestFocusInWindow();
              }));
      file.ifPresent(open::add);
      file.map(Path::getParent).ifPresent(folders::add);
    }
    QuickPick pick = QuickPick.ask(editor.current().area(), text("scriptToOpen"), items);
    folders.forEach(folder -> worker.run(0, () -> list(folder, open, pick)));
  }

  /** On the worker thread. */
  private void list(Path folder, Set<Path> open, QuickPick pick) {
    try {
      List<QuickPick.Item> found =
          ScriptFolder.list(folder, MAX_FILES, () -> !pick.open()).stream()
              .filter(file -> !open.contains(file))
              .map(
                  file ->
                      new QuickPick.Item(
                          folder.relativize(file).toString(),
                          folder.toString(),
                          () -> editor.open(file)))
              .toList();
      EventQueue.invokeLater(() -> pick.add(found));
    } catch (IOException e) {
      EventQueue.invokeLater(() -> pick.say(text("notListed", e.getMessage())));
    }
  }

  /** Offers what the program in front defines. */
  void symbols() {
    ProgramEditor program = editor.current();
    program.whenAnalysed(
        analysed -> {
          List<QuickPick.Item> items = new ArrayList<>();
          add(analysed.outline(), program, analysed, items);
          QuickPick.ask(program.area(), text("functionThreadOrGlobal"), items);
        });
  }

  private void add(
      List<OutlineItem> outline,
      ProgramEditor program,
      AnalysedText analysed,
      List<QuickPick.Item> items) {
    for (OutlineItem each : outline) {
      TextSpan span = analysed.span(each.nameRange());
      int line = analysed.line(span.start());
      items.add(
          new QuickPick.Item(
              ByteText.decoded(each.name() + each.detail()),
              text("lineNumbered", line),
              () -> program.jump(span)));
      add(each.children(), program, analysed, items);
    }
  }
}
