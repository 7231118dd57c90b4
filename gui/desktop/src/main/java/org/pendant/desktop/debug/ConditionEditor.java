package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.awt.Component;
import java.util.function.IntUnaryOperator;
import javax.swing.DefaultCellEditor;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/**
 * Condition editor: edits the condition of a breakpoint, or its message: it is read while it is
 * typed, a label says what is wrong, and a wrong one is not taken.
 */
@SuppressWarnings("serial") // never written to a stream
final class ConditionEditor extends DefaultCellEditor {
  private final JTextField field;
  private final JLabel why;
  private final String kind;
  private final ConditionCheck check;
  private final IntUnaryOperator lineOfRow;
  private final FieldCompletions completions;
  private int line;
  private boolean editing;

  private ConditionEditor(
      String name,
      String kind,
      String tip,
      JLabel why,
      ConditionCheck check,
      IntUnaryOperator lineOfRow) {
    super(new JTextField());
    this.kind = kind;
    this.why = why;
    this.check = check;
    this.lineOfRow = lineOfRow;
    field = (JTextField) getComponent();
    field.setName("breakpoint-" + name);
    field.putClientProperty("FlatLaf.styleClass", "monospaced");
    field.getAccessibleContext().setAccessibleName(text("fieldOfBreakpoint", kind));
    field.setToolTipText(text("tipWithCompletion", tip));
    completions = new FieldCompletions(field, this::complete);
    field.getDocument().addDocumentListener(new Typed());
  }

  /**
   * An editor of conditions.
   *
   * @param why says what is wrong
   * @param lineOfRow the line of the breakpoint in a row of the table
   */
  static ConditionEditor ofConditions(
      JLabel why, ConditionCheck check, IntUnaryOperator lineOfRow) {
    return new ConditionEditor(
        "condition", text("condition"), text("anExpressionSuchAsCount3"), why, check, lineOfRow);
  }

  /** An editor of messages, as {@link #ofConditions}. */
  static ConditionEditor ofMessages(JLabel why, ConditionCheck check, IntUnaryOperator lineOfRow) {
    return new ConditionEditor(
        "message",
        text("message"),
        text("aTextWithExpressionsInBraces"),
        why,
        check.forMessages(),
        lineOfRow);
  }

  @Override
  public Component getTableCellEditorComponent(
      JTable table, Object value, boolean selected, int row, int column) {
    editing = false;
    line = lineOfRow.applyAsInt(row);
    Component editor = super.getTableCellEditorComponent(table, value, selected, row, column);
    editing = true;
    if (field.getText().equals(firstMessage(line))) {
      field.selectAll();
    }
    show("");
    return editor;
  }

  /** The message of a breakpoint until people have typed theirs. */
  static String firstMessage(int line) {
    return text("firstMessage", line);
  }

  private void complete() {
    String text = field.getText();
    int caret = field.getCaretPosition();
    check.complete(
        line,
        text,
        caret,
        found -> {
          if (editing && field.getText().equals(text) && field.getCaretPosition() == caret) {
            completions.offer(found);
          }
        });
  }

  private void typed() {
    if (editing) {
      String text = field.getText();
      check.check(
          line,
          text,
          refusal -> {
            if (editing && field.getText().equals(text)) {
              show(refusal);
            }
          });
    }
  }

  private void show(String refusal) {
    field.putClientProperty("JComponent.outline", refusal.isEmpty() ? null : "error");
    why.setText(refusal.isEmpty() ? "" : Messages.told(kind, refusal));
    why.setToolTipText(refusal.isEmpty() ? null : refusal);
    why.setForeground(Palette.error());
    why.setVisible(!refusal.isEmpty());
  }

  @Override
  public boolean stopCellEditing() {
    String refusal = check.now(line, field.getText());
    show(refusal);
    if (!refusal.isEmpty() || !super.stopCellEditing()) {
      return false;
    }
    end();
    return true;
  }

  @Override
  public void cancelCellEditing() {
    end();
    super.cancelCellEditing();
  }

  private void end() {
    editing = false;
    completions.hide();
    show("");
  }

  /** Reads what is typed. */
  private final class Typed implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent event) {
      typed();
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
      typed();
    }

    @Override
    public void changedUpdate(DocumentEvent event) {}
  }
}
