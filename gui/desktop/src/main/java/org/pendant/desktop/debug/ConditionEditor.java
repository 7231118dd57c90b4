package org.pendant.desktop.debug;

import java.awt.Component;
import java.util.function.IntUnaryOperator;
import javax.swing.DefaultCellEditor;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import org.pendant.kit.theme.Palette;

/**
 * Condition editor: edits the condition of a breakpoint: it is read while it is typed, a label says
 * what is wrong, and a wrong one is not taken.
 */
@SuppressWarnings("serial") // never written to a stream
final class ConditionEditor extends DefaultCellEditor {
  private final JTextField field;
  private final JLabel why;
  private final ConditionCheck check;
  private final IntUnaryOperator lineOfRow;
  private final FieldCompletions completions;
  private int line;
  private boolean editing;

  /**
   * An editor of conditions.
   *
   * @param why says what is wrong
   * @param lineOfRow the line of the breakpoint in a row of the table
   */
  ConditionEditor(JLabel why, ConditionCheck check, IntUnaryOperator lineOfRow) {
    super(new JTextField());
    this.why = why;
    this.check = check;
    this.lineOfRow = lineOfRow;
    field = (JTextField) getComponent();
    field.setName("breakpoint-condition");
    field.putClientProperty("FlatLaf.styleClass", "monospaced");
    field.getAccessibleContext().setAccessibleName("Condition of the breakpoint");
    field.setToolTipText(
        "An expression, such as count > 3; the program stops when it is true."
            + " Ctrl+Space completes");
    completions = new FieldCompletions(field, this::complete);
    field.getDocument().addDocumentListener(new Typed());
  }

  @Override
  public Component getTableCellEditorComponent(
      JTable table, Object value, boolean selected, int row, int column) {
    editing = false;
    line = lineOfRow.applyAsInt(row);
    Component editor = super.getTableCellEditorComponent(table, value, selected, row, column);
    editing = true;
    show("");
    return editor;
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
    why.setText(refusal.isEmpty() ? "" : "Condition: " + refusal);
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
