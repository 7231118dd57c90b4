package org.pendant.desktop.debug;

import java.util.function.UnaryOperator;
import javax.swing.DefaultCellEditor;
import javax.swing.JLabel;
import javax.swing.JTextField;
import org.pendant.kit.theme.Palette;

/**
 * Checked cell editor: edits a cell and stays open while what is typed is refused; a label says
 * why.
 */
@SuppressWarnings("serial") // never written to a stream
public final class CheckedField extends DefaultCellEditor {
  private final JTextField field;
  private final JLabel why;
  private final UnaryOperator<String> refusal;

  /**
   * @param why says why something is refused
   * @param refusal why a text is; empty text if it is not
   */
  public CheckedField(String name, JLabel why, UnaryOperator<String> refusal) {
    super(new JTextField());
    field = (JTextField) getComponent();
    field.setName(name);
    field.putClientProperty("FlatLaf.styleClass", "monospaced");
    field.getAccessibleContext().setAccessibleName(name.replace('-', ' '));
    this.why = why;
    this.refusal = refusal;
  }

  @Override
  public boolean stopCellEditing() {
    String refused = refusal.apply(field.getText());
    field.putClientProperty("JComponent.outline", refused.isEmpty() ? null : "error");
    say(refused);
    return refused.isEmpty() && super.stopCellEditing();
  }

  @Override
  public void cancelCellEditing() {
    field.putClientProperty("JComponent.outline", null);
    say("");
    super.cancelCellEditing();
  }

  private void say(String refused) {
    why.setText(refused);
    why.setForeground(Palette.error());
    why.setVisible(!refused.isEmpty());
  }
}
