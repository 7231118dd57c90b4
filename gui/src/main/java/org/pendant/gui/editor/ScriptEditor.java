package org.pendant.gui.editor;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.pendant.gui.editor.text.Background;
import org.pendant.gui.editor.text.Place;
import org.pendant.gui.session.ProgramDocument;
import org.pendant.gui.session.ProgramFile;
import org.pendant.gui.session.Programs;
import org.pendant.gui.workbench.Actions;
import org.pendant.gui.workbench.View;
import org.pendant.gui.workbench.Workbench;
import org.pendant.language.signature.Catalogue;

/** The screen where scripts are written: the open programs as tabs. Lines count from 1. */
public final class ScriptEditor implements View {
  /** Its name in settings and commands. */
  public static final String ID = "script";

  private static final String SAVE = "file.save";

  private final Workbench workbench;
  private final Programs programs;
  private final Background worker = new WorkerThread("script-editor");
  private final JPanel content = new JPanel(new BorderLayout());
  private final List<EditorListener> listeners = new ArrayList<>();
  private final List<BreakpointListener> breakpointListeners = new ArrayList<>();
  private final EditorTabs tabs;
  private final FindBar find;
  private PlacesSink places = (title, found) -> {};

  /** Where lists of places are shown. */
  interface PlacesSink {
    void show(String title, List<Place> places);
  }

  /** The editor of {@code programs}; it adds its actions to the workbench. */
  public ScriptEditor(Workbench workbench, Programs programs) {
    assert EventQueue.isDispatchThread();
    this.workbench = workbench;
    this.programs = programs;
    Catalogue catalogue = workbench.session().controller().builtins();
    EditorDesk desk = new Desk();
    find = new FindBar(this::current);
    tabs =
        new EditorTabs(
            programs,
            program -> new ProgramEditor(program, catalogue, worker, desk, this::isTaken),
            this::close,
            this::tabShown);
    content.setName("script-editor");
    content.add(find, BorderLayout.SOUTH);
    content.add(tabs);
    EditorActions.addTo(workbench.actions(), this);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return "Script";
  }

  @Override
  public JComponent component() {
    return content;
  }

  /** Opens a file, or brings it to the front if it is open. */
  public void open(Path file) {
    openThen(file, () -> {});
  }

  /** Selects a place of the program in front; columns count characters from 1. */
  public void show(int line, int column) {
    current().show(line, column, 0);
    current().area().requestFocusInWindow();
  }

  /** Marks the line of a program that runs; 0 for none. The text does not scroll. */
  public void setExecutionLine(ProgramDocument program, int line) {
    editor(program).ifPresent(editor -> editor.setExecutionLine(line));
  }

  /** The lines of a program that have a breakpoint. */
  public SortedSet<Integer> breakpoints(ProgramDocument program) {
    return editor(program)
        .map(ProgramEditor::breakpoints)
        .orElseGet(java.util.Collections::emptySortedSet);
  }

  /** Sets or clears a breakpoint, on the next line where the program can stop. */
  public void toggleBreakpoint(ProgramDocument program, int line) {
    editor(program).ifPresent(editor -> editor.toggleBreakpoint(line));
  }

  /** Tells {@code listener} of breakpoints that are set and cleared. */
  public void addBreakpointListener(BreakpointListener listener) {
    breakpointListeners.add(listener);
  }

  /** Closes the program in front; asks if it has changes that are not saved. */
  public void close() {
    close(current());
  }

  /** Puts a line below the one of the caret, indented as that is. */
  public void insertLine(String text) {
    current().area().insertLine(text);
  }

  /** The line of the caret in the program in front, from 1. */
  public int caretLine() {
    ScriptArea area = current().area();
    return area.lineAt(area.getCaretPosition());
  }

  ProgramEditor current() {
    return tabs.current();
  }

  FindBar find() {
    return find;
  }

  Programs programs() {
    return programs;
  }

  void addListener(EditorListener listener) {
    listeners.add(listener);
  }

  void setPlaces(PlacesSink sink) {
    places = sink;
  }

  /** Opens the program of a place and selects it. */
  void show(Place place) {
    Runnable select =
        () -> {
          workbench.show(ID);
          current().show(place.line(), place.column(), place.length());
          current().area().requestFocusInWindow();
        };
    place.file().ifPresentOrElse(file -> openThen(file, select), select);
  }

  private void openThen(Path file, Runnable then) {
    programs
        .of(file)
        .ifPresentOrElse(
            program -> {
              programs.select(program);
              then.run();
            },
            () -> worker.run(0, () -> read(file, then)));
  }

  /** On the worker thread. */
  private void read(Path file, Runnable then) {
    try {
      ProgramFile read = ProgramFile.read(file);
      EventQueue.invokeLater(
          () -> {
            programs.select(programs.of(file).orElseGet(() -> ProgramDocument.of(read)));
            then.run();
          });
    } catch (IOException e) {
      EventQueue.invokeLater(() -> workbench.notify("Not opened: " + e.getMessage()));
    }
  }

  private void close(ProgramEditor editor) {
    ProgramDocument program = editor.program();
    if (!program.modified()) {
      closeNow(program);
      return;
    }
    programs.select(program);
    Map<String, Runnable> answers = new LinkedHashMap<>();
    if (program.file().isPresent()) {
      answers.put("Save and close", () -> saveAndClose(program));
    } else {
      answers.put("Save", () -> workbench.actions().run(SAVE));
    }
    answers.put("Close without saving", () -> closeNow(program));
    answers.put("Keep open", () -> editor.area().requestFocusInWindow());
    editor.notice().ask(program.name() + " has changes that are not saved.", answers);
  }

  /**
   * The window knows how to save; the program is closed once it is on disk. Writing on means that
   * it stays.
   */
  private void saveAndClose(ProgramDocument program) {
    program.addListener(
        new ProgramDocument.Listener() {
          @Override
          public void textChanged(int offset, int removed, String added) {
            program.removeListener(this);
          }

          @Override
          public void fileChanged() {
            if (!program.modified()) {
              program.removeListener(this);
              EventQueue.invokeLater(() -> closeNow(program));
            }
          }
        });
    workbench.actions().run(SAVE);
  }

  private void closeNow(ProgramDocument program) {
    programs.close(program, ProgramDocument.untitled("untitled.script", ""));
    current().area().requestFocusInWindow();
  }

  private Optional<ProgramEditor> editor(ProgramDocument program) {
    return tabs.all().stream().filter(each -> each.program() == program).findFirst();
  }

  /** Whether a key does something in the window, so that texts must leave it alone. */
  private boolean isTaken(KeyStroke key) {
    Actions actions = workbench.actions();
    return actions.all().stream()
        .anyMatch(action -> key.equals(KeyStroke.getKeyStroke(actions.keysOf(action.id()))));
  }

  private void tabShown() {
    find.refresh();
    tellListeners();
  }

  private void tellListeners() {
    listeners.forEach(EditorListener::editorChanged);
  }

  /** What editors of single programs ask for. */
  private final class Desk implements EditorDesk {
    @Override
    public void tell(String sentence) {
      workbench.notify(sentence);
    }

    @Override
    public void list(String title, List<Place> found) {
      places.show(title, found);
      workbench.show(PlacesView.ID);
    }

    @Override
    public void changed(ProgramEditor editor) {
      if (tabs != null && editor == tabs.current()) {
        tellListeners();
      }
    }

    @Override
    public void breakpointsChanged(ProgramEditor editor) {
      breakpointListeners.forEach(
          each -> each.breakpointsChanged(editor.program(), editor.breakpoints()));
    }
  }
}
