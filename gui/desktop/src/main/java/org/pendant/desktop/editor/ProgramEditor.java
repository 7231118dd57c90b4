package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.HierarchyEvent;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.function.Consumer;
import java.util.function.IntUnaryOperator;
import java.util.function.Predicate;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.fife.ui.rsyntaxtextarea.ErrorStrip;
import org.fife.ui.rsyntaxtextarea.parser.ParserNotice;
import org.fife.ui.rtextarea.RTextScrollPane;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.AnalysisSchedule;
import org.pendant.desktop.editor.text.Insertion;
import org.pendant.desktop.editor.text.LineColours;
import org.pendant.desktop.editor.text.Problem;
import org.pendant.desktop.editor.text.RichText;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.kit.background.WorkQueue;
import org.pendant.kit.dock.Dockable;
import org.pendant.kit.theme.LookFollower;
import org.pendant.language.service.Hover;
import org.pendant.language.signature.Catalogue;

/**
 * Program editor: the editor of one open program: its text, and everything that helps to write it.
 */
@SuppressWarnings("serial") // never written to a stream
final class ProgramEditor extends JPanel implements LookFollower {
  private final ProgramDocument program;
  private final ProgramDocument script;
  private final EditorHost editorHost;
  private final LineColours colours;
  private final AnalysisSchedule schedule;
  private final ScriptArea area;
  private final RTextScrollPane scroll;
  private final LineBars bars;
  private final ProblemNotices notices = new ProblemNotices();
  private final NoticeBar notice = new NoticeBar();
  private final GutterMarks marks;
  private final DocumentLink link;
  private final CompletionPopup completions;
  private final SignaturePopup signature;
  private final NameHelp nameHelp;
  private final FixMenu fixes;
  private final NameCommands names;
  private final LayoutCommands layout;
  private final Occurrences occurrences;
  private final TextReturn coming;
  private final LineFollower follower;
  private boolean movingLines;

  ProgramEditor(
      ProgramDocument program,
      Catalogue catalogue,
      WorkQueue background,
      EditorHost editorHost,
      Predicate<KeyStroke> takenKeys,
      FollowSwitch following) {
    super(new BorderLayout());
    this.program = program;
    script = program.script();
    this.editorHost = editorHost;
    colours = new LineColours(catalogue);
    schedule =
        new AnalysisSchedule(
            background,
            EventQueue::invokeLater,
            catalogue,
            script.name(),
            script::text,
            this::show,
            System::nanoTime);
    area = new ScriptArea(colours, schedule::current, takenKeys);
    // also the script of a tree, which cannot be edited
    area.putClientProperty(Dockable.TAKES_KEYS, true);
    scroll = new RTextScrollPane(area, true);
    scroll.setFoldIndicatorEnabled(true);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    area.addParser(notices);
    link = new DocumentLink(area, script, colours, this::textChanged);
    marks =
        new GutterMarks(
            area,
            scroll.getGutter(),
            this::toggleBreakpoint,
            this::fix,
            line -> editorHost.marginMenu(this, line));
    fixes = new FixMenu(area, schedule, background, marks, editorHost);
    signature = new SignaturePopup(area, schedule);
    nameHelp = new NameHelp(area, schedule);
    completions = new CompletionPopup(area, schedule, background, signature::request);
    names =
        new NameCommands(
            area, script, schedule, background, editorHost, () -> editorHost.leaving(this));
    layout = new LayoutCommands(this, schedule, background, link, editorHost);
    occurrences = new Occurrences(area, schedule, background);
    area.setTips(this::tip);
    area.setTyped(
        c -> {
          completions.typed((char) c);
          signature.typed((char) c);
        });
    area.addCaretListener(event -> caretMoved());
    area.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            hidePopups();
          }
        });
    area.setEditable(editable());
    coming = new TextReturn(area, marks);
    follower = new LineFollower(area, scroll, following);
    area.addHierarchyListener(this::shown);
    add(head(), BorderLayout.NORTH);
    bars = new LineBars(area, scroll.getGutter());
    scroll.setRowHeaderView(bars);
    add(scroll);
    add(stripe(), BorderLayout.LINE_END);
    applyTheme();
    textChanged();
  }

  private JPanel head() {
    JPanel head = new JPanel(new BorderLayout());
    if (generated()) {
      head.add(new GeneratedBar(program, editorHost), BorderLayout.NORTH);
    } else if (program.received()) {
      ReceivedBar bar = new ReceivedBar(program, editorHost);
      head.add(bar, BorderLayout.NORTH);
      program.addListener(
          new ProgramDocument.Listener() {
            @Override
            public void fileChanged() {
              bar.look();
              area.setEditable(editable());
            }
          });
    }
    head.add(notice, BorderLayout.SOUTH);
    return head;
  }

  /** The caret may have moved while the text was not shown. */
  private void shown(HierarchyEvent event) {
    boolean shown = (event.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0;
    if (shown && area.isShowing()) {
      boolean toCaret = generated() || coming.unseen();
      TextSpan caret = new TextSpan(area.getCaretPosition(), area.getCaretPosition());
      EventQueue.invokeLater(
          () -> {
            if (toCaret) {
              area.show(caret);
            }
            follower.look();
          });
    }
  }

  /** Whether the text can be changed here. */
  boolean editable() {
    return !generated() && !program.received();
  }

  /** Whether the text comes from a tree, so that it cannot be changed here. */
  boolean generated() {
    return program.isTree();
  }

  /**
   * Shows what a tree generates now.
   *
   * @param newLine where each line with a breakpoint is afterwards; 0 for nowhere
   */
  void replace(String text, IntUnaryOperator newLine) {
    if (text.equals(script.text())) {
      return;
    }
    boolean gone = false;
    for (int line : marks.breakpoints()) {
      if (newLine.applyAsInt(line) == 0) {
        marks.removeBreakpoint(line);
        gone = true;
      }
    }
    moveLines(() -> script.setText(text), newLine);
    area.discardAllEdits();
    if (coming.setBreakpoints() || gone) {
      editorHost.breakpointsChanged(this);
    }
  }

  /** Shows what stands behind lines. */
  void showNotes(Map<Integer, LineNote> notes) {
    bars.showNotes(notes);
  }

  /** Shows what tests have reached of lines. */
  void showCover(Map<Integer, LineCover> lines) {
    bars.cover().set(lines);
    editorHost.changed(this);
  }

  /** What tests have reached of the line of the caret. */
  Optional<LineCover> coverAtCaret() {
    return bars.cover().line(area.lineAt(area.getCaretPosition()));
  }

  private ErrorStrip stripe() {
    ErrorStrip stripe = new ErrorStrip(area);
    stripe.setName("problem-stripe");
    stripe.setLevelThreshold(ParserNotice.Level.WARNING);
    stripe.setShowMarkAll(true);
    stripe.getAccessibleContext().setAccessibleName(text("problemsAlongTheText"));
    return stripe;
  }

  ProgramDocument program() {
    return program;
  }

  ScriptArea area() {
    return area;
  }

  /** Asks things above the text. */
  NoticeBar notice() {
    return notice;
  }

  NameCommands names() {
    return names;
  }

  LayoutCommands layoutCommands() {
    return layout;
  }

  FixMenu fixes() {
    return fixes;
  }

  /** What is known about the text as it is. */
  Optional<AnalysedText> analysed() {
    return schedule.current();
  }

  /** Hands over what is known as soon as it is. */
  void whenAnalysed(Consumer<AnalysedText> receiver) {
    schedule.whenCurrent(receiver);
  }

  /** Whether the text is checked only after longer pauses. */
  boolean isLong() {
    return schedule.isLong();
  }

  /** Selects a place, to come back from it later. */
  void jump(TextSpan span) {
    editorHost.leaving(this);
    area.show(span);
    area.requestFocusInWindow();
  }

  void complete() {
    completions.request(true);
  }

  void showSignature() {
    signature.request();
  }

  /** Opens the menu of quick fixes. */
  void fix() {
    if (editable()) {
      fixes.open();
    }
  }

  /** Lets no popup stay when the program is no longer in front. */
  void hidePopups() {
    completions.hide();
    signature.hide();
    nameHelp.hide();
  }

  /** Shows what is known about the name at the caret. */
  NameHelp nameHelp() {
    return nameHelp;
  }

  /** Replaces many stretches as one step. */
  void gather(Runnable edits) {
    link.gather(edits);
  }

  /** Selects a place; line and column (in characters) count from 1. */
  void show(int line, int column, int length) {
    TextSpan whole = area.line(line);
    int start = Math.min(whole.end(), whole.start() + Math.max(0, column - 1));
    area.show(new TextSpan(start, start + length));
  }

  void setExecution(Execution execution) {
    marks.setExecution(execution);
    follower.at(execution.line());
  }

  /** Has the line that runs in sight, if people want it so. */
  void follow() {
    follower.look();
  }

  /** Scrolls a line into sight unless it is. */
  void reveal(int line) {
    follower.reveal(line);
  }

  SortedSet<Integer> breakpoints() {
    return coming.breakpoints();
  }

  /** Sets breakpoints on lines that had them when this program was open last. */
  void restoreBreakpoints(SortedSet<Integer> lines) {
    coming.bringBreakpoints(lines, generated() && script.text().isEmpty());
  }

  /** Goes to where people were when this program was open last. */
  void restore(TextPlace place) {
    if (!generated()) {
      coming.go(place);
    }
  }

  /** Where people are now. */
  TextPlace place() {
    return generated() ? TextPlace.START : coming.place();
  }

  /** Shows what others know of breakpoints, by their lines. */
  void showBreakpoints(Map<Integer, BreakpointMark> looks) {
    marks.setLooks(looks);
  }

  /** Does an edit that takes lines to other places; breakpoints go with them. */
  void moveLines(Runnable edit, IntUnaryOperator newLine) {
    movingLines = true;
    marks.whileMoving(edit, newLine);
    movingLines = false;
    tellMoves();
  }

  /** Sets or clears a breakpoint on a line, or on the next where the program can stop. */
  void toggleBreakpoint(int line) {
    if (marks.breakpoints().contains(line)) {
      marks.removeBreakpoint(line);
      editorHost.breakpointsChanged(this);
      return;
    }
    boolean early = analysed().isEmpty();
    if (early) {
      // At once, for a user who runs the program with the next key; it moves when the text is read.
      marks.addBreakpoint(line);
      editorHost.breakpointsChanged(this);
    }
    schedule.whenCurrent(
        analysed -> {
          // It may have been cleared again meanwhile.
          if (!early || marks.breakpoints().contains(line)) {
            place(line, analysed.analysis().breakpointLines().tailSet(line));
          }
        });
  }

  private void place(int line, SortedSet<Integer> possible) {
    if (possible.isEmpty()) {
      marks.removeBreakpoint(line);
      editorHost.tell(text("noBreakpointNothingRunsOnLine", line));
    } else if (possible.first() != line) {
      marks.removeBreakpoint(line);
      marks.addBreakpoint(possible.first());
    } else {
      marks.addBreakpoint(line);
    }
    editorHost.breakpointsChanged(this);
  }

  /** Forgets the program; the editor is not used again. */
  void end() {
    hidePopups();
    editorHost.ending(this);
    link.end();
  }

  void zoom(int points) {
    area.setZoom(points == 0 ? 0 : area.zoom() + points);
    applyTheme();
  }

  private void applyTheme() {
    scroll.setBorder(BorderFactory.createEmptyBorder());
    EditorTheme.apply(area, scroll);
    area.themeChanged();
    marks.refresh();
    occurrences.themeChanged();
    area.forceReparsing(notices);
  }

  @Override
  public void lookChanged() {
    applyTheme();
  }

  private void textChanged() {
    schedule.changed();
    if (!movingLines && !marks.breakpoints().isEmpty()) {
      tellMoves();
    }
  }

  private void tellMoves() {
    SortedMap<Integer, Integer> moves = marks.takeMoves();
    if (!moves.isEmpty()) {
      marks.refresh();
      editorHost.breakpointsMoved(this, moves);
    }
  }

  private void show(AnalysedText analysed) {
    colours
        .set(analysed)
        .ifPresent(lines -> area.repaintLines(lines.first() + 1, lines.last() + 1));
    if (notices.set(analysed.problems())) {
      area.forceReparsing(notices);
    }
    area.getFoldManager().reparse();
    coming.fold();
    marks.setStatementLines(analysed.statementLines());
    fixes.forget();
    fixes.refreshBulb();
    editorHost.changed(this);
  }

  private void caretMoved() {
    fixes.refreshBulb();
    editorHost.changed(this);
  }

  /** What to say about a character: its problems, or else what is known about the name. */
  private Optional<String> tip(int offset) {
    return analysed()
        .flatMap(
            analysed ->
                analysed.problems().stream()
                    .filter(problem -> isOn(problem, offset))
                    .findFirst()
                    .map(RichText::of)
                    .or(() -> analysed.hover(offset).map(about -> withValue(about, offset)))
                    .or(
                        () ->
                            analysed
                                .quantity(offset)
                                .map(each -> RichText.of(each, editorHost.units()))));
  }

  /** What is known about a name, below what it is if it is a variable of the program that ran. */
  private String withValue(Hover about, int offset) {
    String text = area.getText();
    int start = Insertion.wordStart(text, offset);
    int end = offset;
    while (end < text.length() && Insertion.isWord(text.charAt(end))) {
      end++;
    }
    String name = text.substring(start, end);
    return editorHost
        .value(this, name)
        .map(value -> RichText.of(name, value, editorHost.units(), about))
        .orElseGet(() -> RichText.of(about));
  }

  private static boolean isOn(Problem problem, int offset) {
    int end = Math.max(problem.span().end(), problem.span().start() + 1);
    return problem.span().start() <= offset && offset < end;
  }
}
