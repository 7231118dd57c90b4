package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.Component;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.background.Background;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.project.program.file.BrokenTree;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.urp.UrpPrograms;

/** Export of programs of nodes for PolyScope; what no robot will understand is told before. */
final class UrpExport {
  private static final int SHOWN_NOTES = 8;

  private final Programs programs;
  private final Supplier<Installation> installation;
  private final Notices notices;
  private final Component parent;
  private final Consumer<String> tell;

  /** A file that could be written. */
  private record Draft(TreeFile file, List<String> notes) {
    String name() {
      return file.programName();
    }

    byte[] bytes() {
      return UrpPrograms.write(name(), file.tree(), file.installation());
    }
  }

  UrpExport(
      Programs programs,
      Supplier<Installation> installation,
      Notices notices,
      Component parent,
      Consumer<String> tell) {
    this.programs = programs;
    this.installation = installation;
    this.notices = notices;
    this.parent = parent;
    this.tell = tell;
  }

  void addAction(ActionTable actions) {
    actions.add(
        new Action(
            "file.export-urp",
            text("exportAsUrpExperimental"),
            "",
            () -> programs.current().isTree(),
            () -> ask(programs.current())),
        () -> text("theProgramIsAScript"));
  }

  private void ask(ProgramDocument document) {
    String name = document.bareName();
    String text = document.text();
    Installation installed = installation.get();
    Background.run(
        () -> draft(name, text, installed),
        draft -> ask(document, draft),
        failed -> notices.tell("urp-export", text("notExported", failed.getMessage())));
  }

  private static Draft draft(String name, String text, Installation installed) throws IOException {
    try {
      TreeFile file =
          TreeFile.read(name + ProgramDocument.TREE, text.getBytes(StandardCharsets.UTF_8))
              .in(installed);
      return new Draft(
          file, UrpPrograms.notes(file.programName(), file.tree(), file.installation()));
    } catch (BrokenTree e) {
      throw new IOException(String.join("\n", e.reports()), e);
    }
  }

  private void ask(ProgramDocument document, Draft draft) {
    notices.ask(
        "urp-export",
        draft.name() + UrpPrograms.ENDING + ":\n" + listed(draft.notes()),
        List.of(
            new Choice("export", text("exportButton"), () -> save(document, draft)),
            Choice.nothing("cancel", text("cancel"))));
    notices.focus();
  }

  /** As many as there is room for. */
  static String listed(List<String> notes) {
    String shown =
        String.join("\n", notes.stream().limit(SHOWN_NOTES).map(note -> "\u2022 " + note).toList());
    return notes.size() <= SHOWN_NOTES
        ? shown
        : text("andMoreNotesPendantConvertLists", shown, notes.size() - SHOWN_NOTES);
  }

  private void save(ProgramDocument document, Draft draft) {
    Path name = Path.of(draft.name() + UrpPrograms.ENDING);
    SaveDialog.open(
        parent,
        new SaveRequest(
            text("exportAsUrp", document.name()),
            document
                .file()
                .map(file -> file.toAbsolutePath().resolveSibling(name))
                .orElse(Path.of(System.getProperty("user.home")).resolve(name)),
            List.of(UrpPrograms.ENDING.substring(1)),
            EditedFiles.besides(document, programs)),
        file -> AtomicFile.write(file, draft.bytes()),
        tell);
  }
}
