package org.pendant.gui.editor;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.Optional;
import java.util.SortedSet;
import java.util.function.Predicate;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.fife.ui.rsyntaxtextarea.ErrorStrip;
import org.fife.ui.rsyntaxtextarea.parser.ParserNotice;
import org.fife.ui.rtextarea.RTextScrollPane;
import org.pendant.gui.editor.text.AnalysedText;
import org.pendant.gui.editor.text.AnalysisSchedule;
import org.pendant.gui.editor.text.Background;
import org.pendant.gui.editor.text.LineColours;
import org.pendant.gui.editor.text.Problem;
import org.pendant.gui.editor.text.RichText;
import org.pendant.gui.editor.text.Span;
import org.pendant.gui.session.ProgramDocument;
import org.pendant.language.signature.Catalogue;

/** The editor of one open program: its text, and everything that helps to write it. */
@SuppressWarnings("serial") // never written to a stream
final class ProgramEditor extends JPanel {
  private final ProgramDocument program;
  private final EditorDesk desk;
  private final LineColours colours;
  private final AnalysisSchedule schedule;
  private final ScriptArea area;
  private final RTextScrollPane scroll;
  private final ProblemNotices notices = new ProblemNotices();
  private final NoticeBar notice = new NoticeBar();
  private final GutterMarks marks;
  private final DocumentLink link;
  private final CompletionPopup completions;
  private final SignaturePopup signature;
  private final FixMenu fixes;
  private final NameCommands names;
  private final LayoutCommands layout;

  ProgramEditor(
      ProgramDocument program,
      Catalogue catalogue,
      Background background,
      EditorDesk desk,
      Predicate<KeyStroke> takenKeys) {
    super(new BorderLayout());
    this.program = program;
    this.desk = desk;
    colours = new LineColours(catalogue);
    schedule =
        new AnalysisSchedule(
            background,
            EventQueue::invokeLater,
            catalogue,
            program.name(),
            program::text,
            this::show);
    area = new ScriptArea(colours, schedule::current, takenKeys);
    scroll = new RTextScrollPane(area, true);
    scroll.setFoldIndicatorEnabled(true);
    scroll.setBorder(null);
    area.addParser(notices);
    link = new DocumentLink(area, program, colours, this::textChanged);
    marks = new GutterMarks(area, scroll.getGutter(), this::toggleBreakpoint, this::fix);
    fixes = new FixMenu(area, schedule, background, marks, desk);
    signature = new SignaturePopup(area, schedule);
    completions = new CompletionPopup(area, schedule, background, signature::request);
    names = new NameCommands(area, program, schedule, background, desk);
    layout = new LayoutCommands(area, schedule, background, link, desk);
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
    add(notice, BorderLayout.NORTH);
    add(scroll);
    add(stripe(), BorderLayout.LINE_END);
    applyTheme();
    textChanged();
  }

  private ErrorStrip stripe() {
    ErrorStrip stripe = new ErrorStrip(area);
    stripe.setName("problem-stripe");
    stripe.setLevelThreshold(ParserNotice.Level.WARNING);
    stripe.setShowMarkAll(true);
    stripe.getAccessibleContext().setAccessibleName("Problems along the text");
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

  void complete() {
    completions.request(true);
  }

  void showSignature() {
    signature.request();
  }

  /** Opens the menu of quick fixes. */
  void fix() {
    fixes.open();
  }

  /** Lets no popup stay when the program is no longer in front. */
  void hidePopups() {
    completions.hide();
    signature.hide();
  }

  /** Replaces many stretches as one step. */
  void gather(Runnable edits) {
    link.gather(edits);
  }

  /** Selects a place; line and column (in characters) count from 1. */
  void show(int line, int column, int length) {
    Span whole = area.line(line);
    int start = Math.min(whole.end(), whole.start() + Math.max(0, column - 1));
    area.show(new Span(start, start + length));
  }

  void setExecutionLine(int line) {
    marks.setExecutionLine(line);
  }

  SortedSet<Integer> breakpoints() {
    return marks.breakpoints();
  }

  /** Sets or clears a breakpoint on a line, or on the next where the program can stop. */
  void toggleBreakpoint(int line) {
    if (marks.breakpoints().contains(line)) {
      marks.removeBreakpoint(line);
      desk.breakpointsChanged(this);
      return;
    }
    schedule.whenCurrent(
        analysed -> {
          SortedSet<Integer> possible = analysed.analysis().breakpointLines().tailSet(line);
          if (possible.isEmpty()) {
            desk.tell("No breakpoint: nothing runs on line " + line + " or below it");
            return;
          }
          marks.addBreakpoint(possible.first());
          desk.breakpointsChanged(this);
        });
  }

  /** Forgets the program; the editor is not used again. */
  void end() {
    hidePopups();
    link.end();
  }

  void zoom(int points) {
    area.setZoom(points == 0 ? 0 : area.zoom() + points);
    applyTheme();
  }

  private void applyTheme() {
    EditorTheme.apply(area, scroll);
    marks.themeChanged();
    area.forceReparsing(notices);
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (scroll != null) {
      // The parts of this panel get their new look after it.
      EventQueue.invokeLater(this::applyTheme);
    }
  }

  private void textChanged() {
    schedule.changed();
  }

  private void show(AnalysedText analysed) {
    colours.set(analysed);
    notices.set(analysed.problems());
    area.forceReparsing(notices);
    area.getFoldManager().reparse();
    area.repaint();
    fixes.forget();
    fixes.refreshBulb();
    desk.changed(this);
  }

  private void caretMoved() {
    fixes.refreshBulb();
    desk.changed(this);
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
                    .or(() -> analysed.hover(offset).map(RichText::of)));
  }

  private static boolean isOn(Problem problem, int offset) {
    int end = Math.max(problem.span().end(), problem.span().start() + 1);
    return problem.span().start() <= offset && offset < end;
  }
}
