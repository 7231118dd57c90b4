package org.pendant.desktop.move;

import java.util.Objects;
import javax.swing.JTextField;
import javax.swing.SwingConstants;
import org.pendant.kit.form.TabSelection;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.Typed;

/**
 * Number field for one number of a {@link Draft}; red-rimmed, with the reason as tip, if it is
 * none.
 */
@SuppressWarnings("serial") // never written to a stream
final class NumberField extends JTextField {
  private static final int COLUMNS = 7;
  private final Draft draft;
  private final int index;
  private final String tip;
  private boolean showing;

  NumberField(Draft draft, int index, String name, String tip) {
    super(COLUMNS);
    this.draft = draft;
    this.index = index;
    this.tip = tip;
    setHorizontalAlignment(SwingConstants.TRAILING);
    TitledCard.named(this, name, tip);
    getDocument().addDocumentListener(new Typed(this::typed));
    TabSelection.of(this);
  }

  private void typed() {
    if (!showing) {
      draft.type(index, getText());
    }
  }

  /**
   * Shows the number as it is now. Where the user has selected all of it to type over, all of the
   * new one is selected; where a part of it is, it stays.
   */
  void refresh() {
    if (!getText().equals(draft.text(index)) && (!isFocusOwner() || !selected() || allSelected())) {
      boolean all = isFocusOwner() && allSelected();
      showing = true;
      setText(draft.text(index));
      showing = false;
      if (all) {
        selectAll();
      }
    }
    String problem = draft.problem(index);
    Object outline = problem.isEmpty() ? null : "error";
    if (!Objects.equals(getClientProperty("JComponent.outline"), outline)) {
      putClientProperty("JComponent.outline", outline);
    }
    String wanted = problem.isEmpty() ? tip : problem;
    if (!wanted.equals(getToolTipText())) {
      setToolTipText(wanted);
      getAccessibleContext().setAccessibleDescription(problem);
    }
  }

  private boolean selected() {
    return getSelectionStart() != getSelectionEnd();
  }

  private boolean allSelected() {
    return selected() && getSelectionEnd() - getSelectionStart() == getDocument().getLength();
  }
}
