package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.IntUnaryOperator;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.Place;
import org.pendant.desktop.editor.text.Problem;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Actions;
import org.pendant.kit.background.WorkQueue;
import org.pendant.kit.background.WorkerThread;
import org.pendant.language.signature.Catalogue;

/**
 * Script editor: the screen where scripts are written: the open programs as tabs. Lines count from
 * 1.
 */
public final class ScriptEditor implements View {
  /** Its name in settings and commands. */
  public static final String ID = "script";

  private final Workbench workbench;
  private final Programs programs;
  private final WorkQueue worker = new WorkerThread("script-editor");
  private final JPanel content = new JPanel(new BorderLayout());
  private final List<EditorListener> listeners = new ArrayList<>();
  private final List<BreakpointListener> breakpointListeners = new ArrayList<>();
  private final EditorTabs tabs;
  private final FindBar find;
  private final EditorStatus status;
  private final ProgramCloser closer;
  private final Navigation navigation;
  private final QuickOpen quickOpen;
  private Function<ProgramDocument, SortedSet<Integer>> breakpointMemory =
      program -> Collections.emptySortedSet();
  private TextMemory memory = TextMemory.NONE;
  private MarginMenu marginMenu = (program, line) -> new JPopupMenu();
  private final FollowSwitch follow;
  private BiFunction<ProgramDocument, String, Optional<String>> values =
      (program, name) -> Optional.empty();
  private final JPanel head = new JPanel(new MigLayout("insets 0 0 0 6, gap 4, hidemode 3"));
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
    Catalogue catalogue = workbench.session().robot().builtins();
    EditorHost editorHost = new Desk();
    follow = new FollowSwitch(workbench.settings());
    find = new FindBar(this::current);
    status = new EditorStatus(() -> workbench.show(ProblemsView.ID));
    closer = new ProgramCloser(workbench, programs, this::current);
    navigation = new Navigation(programs, this::goTo);
    quickOpen = new QuickOpen(this, programs, new WorkerThread("script-finder"));
    tabs =
        new EditorTabs(
            programs,
            program -> {
              ProgramEditor made =
                  new ProgramEditor(program, catalogue, worker, editorHost, this::isTaken, follow);
              made.restoreBreakpoints(breakpointMemory.apply(program));
              memory.of(program).ifPresent(made::restore);
              TextMenu.addTo(made.area(), workbench.actions());
              return made;
            },
            closer::close,
            this::tabShown);
    JPanel south = new JPanel(new BorderLayout());
    south.add(find, BorderLayout.NORTH);
    south.add(status, BorderLayout.SOUTH);
    head.setOpaque(false);
    head.add(follow.button());
    follow.button().addActionListener(event -> current().follow());
    tabs.putClientProperty(FlatClientProperties.TABBED_PANE_TRAILING_COMPONENT, trailing());
    content.setName("script-editor");
    content.add(south, BorderLayout.SOUTH);
    content.add(tabs);
    addListener(() -> status.show(current()));
    status.show(current());
    EditorActions.addTo(workbench.actions(), this);
  }

  /** Makes the editors of the programs behind the one in front, which a start need not wait for. */
  public void openBehind() {
    tabs.follow();
  }

  /** At the end of the row of tabs. */
  private JPanel trailing() {
    JPanel end = new JPanel(new BorderLayout());
    end.setOpaque(false);
    end.add(head, BorderLayout.LINE_END);
    head.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            tabs.showSelected();
          }
        });
    return end;
  }

  /** Puts something into the head of the editor. */
  public void addToHead(JComponent tool) {
    head.add(tool, 0);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("script");
  }

  @Override
  public JComponent component() {
    return content;
  }

  /** Opens a file, or brings it to the front if it is open. */
  public void open(Path file) {
    openThen(file, () -> {});
  }

  /**
   * Selects a place of the program in front, without taking the focus; columns count characters
   * from 1.
   */
  public void show(int line, int column) {
    current().show(line, column, 0);
  }

  /** Puts the caret to the end of the first line of blanks, where a new script is to be written. */
  public void showEmptyBody() {
    List<String> lines = current().area().getText().lines().toList();
    for (int line = 1; line <= lines.size(); line++) {
      if (lines.get(line - 1).isBlank()) {
        show(line, lines.get(line - 1).length() + 1);
        return;
      }
    }
  }

  /** Lets keys go to the text of the program in front. */
  public void focus() {
    current().area().requestFocusInWindow();
  }

  /** Whether the line that runs is kept in sight. */
  boolean follows() {
    return follow.on();
  }

  /** Keeps the line that runs in sight, or no longer. */
  void toggleFollow() {
    follow.choose(!follow.on());
    current().follow();
  }

  /** A program is about to start: its lines are followed again. */
  public void followAgain() {
    follow.again();
  }

  /** Scrolls a line of a program into sight unless it is; the caret stays. */
  public void reveal(ProgramDocument program, int line) {
    editor(program).ifPresent(editor -> editor.reveal(line));
  }

  /** Asks {@code known} for the values of variables that people point at. */
  public void setValues(BiFunction<ProgramDocument, String, Optional<String>> known) {
    values = known;
  }

  /** Marks where a program is; the text follows if people want it so. */
  public void setExecution(ProgramDocument program, Execution execution) {
    editor(program).ifPresent(editor -> editor.setExecution(execution));
  }

  /**
   * Shows the script that a program tree generates now.
   *
   * @param newLine where each line with a breakpoint is afterwards; 0 for nowhere
   */
  public void replaceScript(ProgramDocument program, String text, IntUnaryOperator newLine) {
    editor(program)
        .ifPresentOrElse(
            editor -> editor.replace(text, newLine), () -> program.script().setText(text));
  }

  /** Shows what is known of the breakpoints of a program, by their lines. */
  public void showBreakpoints(ProgramDocument program, Map<Integer, BreakpointMark> looks) {
    editor(program).ifPresent(editor -> editor.showBreakpoints(looks));
  }

  /** Shows what stands behind the lines of a program, by their numbers. */
  public void showNotes(ProgramDocument program, Map<Integer, LineNote> notes) {
    editor(program).ifPresent(editor -> editor.showNotes(notes));
  }

  /** Shows what tests have reached of the lines of a program, by their numbers. */
  public void showCover(ProgramDocument program, Map<Integer, LineCover> lines) {
    editor(program).ifPresent(editor -> editor.showCover(lines));
  }

  /** Asks {@code known} for the breakpoints of programs that are open, or opened again. */
  public void setBreakpointMemory(Function<ProgramDocument, SortedSet<Integer>> known) {
    breakpointMemory = known;
    tabs.all().forEach(each -> each.restoreBreakpoints(known.apply(each.program())));
  }

  /** Has people come back to where they were, in programs that are open, or opened again. */
  public void setTextMemory(TextMemory known) {
    memory = known;
    tabs.all().forEach(each -> known.of(each.program()).ifPresent(each::restore));
  }

  /** Has {@code menu} open beside lines. */
  public void setMarginMenu(MarginMenu menu) {
    marginMenu = menu;
  }

  /** What the check found in the text of a program, its script for a tree; empty while it runs. */
  public Optional<List<Problem>> problems(ProgramDocument program) {
    return editor(program).flatMap(ProgramEditor::analysed).map(AnalysedText::problems);
  }

  /** Where people are in the text of a program. */
  public Optional<TextPlace> place(ProgramDocument program) {
    return editor(program).map(ProgramEditor::place);
  }

  /** The lines of a program that have a breakpoint. */
  public SortedSet<Integer> breakpoints(ProgramDocument program) {
    return editor(program).map(ProgramEditor::breakpoints).orElseGet(Collections::emptySortedSet);
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
    closer.close(current());
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

  /**
   * Shows what is known about the name at the caret, while keys go to the text; {@code otherwise}
   * runs where nothing is.
   */
  public void explain(Runnable otherwise) {
    if (current().area().isFocusOwner()) {
      current().nameHelp().show(otherwise);
    } else {
      otherwise.run();
    }
  }

  ProgramCloser closer() {
    return closer;
  }

  Navigation navigation() {
    return navigation;
  }

  QuickOpen quickOpen() {
    return quickOpen;
  }

  /** Brings the next program to the front, or the one before. */
  void turn(int steps) {
    List<ProgramDocument> all = programs.all();
    int next = Math.floorMod(all.indexOf(programs.current()) + steps, all.size());
    programs.select(all.get(next));
    current().area().requestFocusInWindow();
  }

  private void goTo(ProgramDocument program, int offset) {
    programs.select(program);
    workbench.show(ID);
    current().area().show(new TextSpan(offset, offset));
    current().area().requestFocusInWindow();
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
  public void show(Place place) {
    navigation.left(current());
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
      SavedProgram read = SavedProgram.read(file);
      EventQueue.invokeLater(
          () -> {
            programs.select(programs.of(file).orElseGet(() -> ProgramDocument.of(read)));
            then.run();
          });
    } catch (IOException e) {
      EventQueue.invokeLater(() -> workbench.notify(text("notOpened", e.getMessage())));
    }
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
  private final class Desk implements EditorHost {
    @Override
    public void tell(String sentence) {
      workbench.notify(sentence);
    }

    @Override
    public void run(String action) {
      workbench.actions().run(action);
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
    public void leaving(ProgramEditor editor) {
      navigation.left(editor);
    }

    @Override
    public Optional<String> value(ProgramEditor editor, String name) {
      return values.apply(editor.program(), name);
    }

    @Override
    public PoseForm units() {
      return FormMemory.read(workbench.settings());
    }

    @Override
    public JPopupMenu marginMenu(ProgramEditor editor, int line) {
      return marginMenu.of(editor.program(), line);
    }

    @Override
    public void ending(ProgramEditor editor) {
      memory.closing(editor.program(), editor.place());
    }

    @Override
    public void breakpointsMoved(ProgramEditor editor, SortedMap<Integer, Integer> moves) {
      breakpointListeners.forEach(each -> each.breakpointsMoved(editor.program(), moves));
      breakpointsChanged(editor);
    }

    @Override
    public void breakpointsChanged(ProgramEditor editor) {
      breakpointListeners.forEach(
          each -> each.breakpointsChanged(editor.program(), editor.breakpoints()));
    }
  }
}
