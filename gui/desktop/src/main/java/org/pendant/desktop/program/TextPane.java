package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.awt.BorderLayout;
import java.awt.Component;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.ListSelectionModel;
import javax.swing.UIManager;
import javax.swing.text.BadLocationException;
import javax.swing.undo.UndoManager;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.kit.layout.CodeArea;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Palette;
import org.pendant.project.program.text.TextProblem;

/**
 * Text pane: the text of a program file, to be put right by hand, with what cannot be understood in
 * it.
 */
@SuppressWarnings("serial") // never written to a stream
final class TextPane extends JPanel {
  private final JTextArea about = new JTextArea();
  private final JTextArea text = new CodeArea();
  private final JList<TextProblem> list = new JList<>();
  private final JScrollPane problems = new JScrollPane(list);
  private final JButton back = new JButton(text("showAsTree"));
  private final UndoManager edits = new UndoManager();
  private transient Optional<ProgramDocument> document = Optional.empty();
  private boolean showing;

  /**
   * No text yet.
   *
   * @param done hears that people want the tree again
   */
  TextPane(Runnable done) {
    super(new BorderLayout());
    setName("program-text-pane");
    about.setName("program-text-about");
    about.setEditable(false);
    about.setFocusable(false);
    about.setOpaque(false);
    about.setLineWrap(true);
    about.setWrapStyleWord(true);
    back.setName("program-text-done");
    back.setToolTipText(text("goesBackToTheTreePossible"));
    back.addActionListener(event -> done.run());
    JPanel head = new JPanel(new MigLayout("insets 8 12 8 12, gap 12", "[grow, fill, 0::][]"));
    head.add(about, "wmin 0");
    head.add(back, "aligny top");
    text.setName("program-text");
    text.getAccessibleContext().setAccessibleName(text("textOfTheProgramFile"));
    text.getDocument().addDocumentListener(new Typed(this::typed));
    text.getDocument().addUndoableEditListener(edits);
    key("control Z", () -> edits.canUndo(), edits::undo);
    key("control shift Z", () -> edits.canRedo(), edits::redo);
    list.setName("program-text-problems");
    list.getAccessibleContext().setAccessibleName(text("linesThatCannotBeUnderstood"));
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setCellRenderer(new Cell());
    list.setVisibleRowCount(4);
    list.addListSelectionListener(event -> goTo());
    add(head, BorderLayout.NORTH);
    add(new JScrollPane(text));
    problems.setBorder(BorderFactory.createTitledBorder(text("linesThatCannotBeUnderstood")));
    add(problems, BorderLayout.SOUTH);
    updateUI();
  }

  private void key(String keys, java.util.function.BooleanSupplier can, Runnable run) {
    text.registerKeyboardAction(
        event -> {
          if (can.getAsBoolean()) {
            run.run();
          }
        },
        javax.swing.KeyStroke.getKeyStroke(keys),
        WHEN_FOCUSED);
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (about != null) {
      about.setFont(UIManager.getFont("Label.font"));
    }
  }

  /** Shows the text of a program. */
  void show(TreeProgram program) {
    showing = true;
    boolean other = !document.equals(Optional.of(program.document()));
    document = Optional.of(program.document());
    if (!text.getText().equals(program.document().text())) {
      int caret = text.getCaretPosition();
      text.setText(program.document().text());
      text.setCaretPosition(other ? 0 : Math.min(caret, text.getDocument().getLength()));
      edits.discardAllEdits();
    }
    showing = false;
    showProblems(program.textProblems());
  }

  private void showProblems(List<TextProblem> found) {
    list.setListData(found.toArray(new TextProblem[0]));
    problems.setVisible(!found.isEmpty());
    back.setEnabled(found.isEmpty());
    about.setText(found.isEmpty() ? text("programAsSaved") : text("cannotBeShownAsTree"));
    about.setForeground(found.isEmpty() ? Palette.quiet() : Palette.warning());
    revalidate();
  }

  void focus() {
    text.requestFocusInWindow();
  }

  private void typed() {
    if (!showing) {
      document.ifPresent(each -> each.setText(text.getText()));
    }
  }

  private void goTo() {
    TextProblem problem = list.getSelectedValue();
    if (problem == null || problem.line() > text.getLineCount()) {
      return;
    }
    try {
      int start = text.getLineStartOffset(problem.line() - 1);
      int end = text.getLineEndOffset(problem.line() - 1);
      text.select(Math.min(end, start + problem.column() - 1), end);
      text.requestFocusInWindow();
    } catch (BadLocationException e) {
      throw new IllegalStateException("line " + problem.line() + " is not in the text", e);
    }
  }

  /** Line and message. */
  private static final class Cell extends DefaultListCellRenderer {
    @Override
    public Component getListCellRendererComponent(
        JList<?> from, Object value, int index, boolean selected, boolean focused) {
      String line =
          value instanceof TextProblem problem
              ? text("lineColumn", problem.line(), problem.column(), problem.message())
              : "";
      super.getListCellRendererComponent(from, line, index, selected, focused);
      setToolTipText(line);
      return this;
    }
  }
}
