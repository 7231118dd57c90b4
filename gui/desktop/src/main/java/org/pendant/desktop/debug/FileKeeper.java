package org.pendant.desktop.debug;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.desktop.editor.ScriptEditor;
import org.pendant.desktop.editor.TextMemory;
import org.pendant.desktop.editor.TextPlace;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.kit.settings.Settings;
import org.pendant.script.debug.Breakpoint;

/**
 * File keeper: has breakpoints, the caret and folds of each file last until it is opened again,
 * also in another window or after a restart.
 */
public final class FileKeeper implements TextMemory {
  private final KeptFiles files;
  private final Programs programs;
  private final ScriptEditor editor;
  private final OpenBreakpoints breakpoints;

  /** Gives the open programs what is remembered of their files. */
  public FileKeeper(
      Settings settings, Programs programs, ScriptEditor editor, OpenBreakpoints breakpoints) {
    this.programs = programs;
    this.editor = editor;
    this.breakpoints = breakpoints;
    files = new KeptFiles(settings);
    breakpoints.setMemory(this::breakpoints);
    editor.setTextMemory(this);
  }

  /** What people should know, such as that a part could not be read. */
  public Optional<String> notice() {
    return files.notice();
  }

  /** Those whose line is there; the lines of a tree's script come later. */
  private List<Breakpoint> breakpoints(ProgramDocument program) {
    long lines = program.isTree() ? Long.MAX_VALUE : 1 + feeds(program.text());
    return kept(program).map(KeptFile::breakpoints).orElse(List.of()).stream()
        .filter(each -> each.line() <= lines)
        .toList();
  }

  private static long feeds(String text) {
    return text.chars().filter(c -> c == '\n').count();
  }

  private Optional<KeptFile> kept(ProgramDocument program) {
    return program.file().flatMap(files::of);
  }

  @Override
  public Optional<TextPlace> of(ProgramDocument program) {
    return kept(program).map(KeptFile::place);
  }

  @Override
  public void closing(ProgramDocument program, TextPlace place) {
    keep(program, place);
    files.write();
  }

  private void keep(ProgramDocument program, TextPlace place) {
    Optional<Path> file = program.file();
    file.ifPresent(path -> files.put(path, new KeptFile(place, breakpoints.all(program))));
  }

  /** Looks at all open programs; called every few seconds and at the end. */
  public void look() {
    programs.all().forEach(each -> editor.place(each).ifPresent(place -> keep(each, place)));
    files.write();
  }
}
