package org.pendant.desktop.program.form;

import java.util.Objects;
import java.util.function.UnaryOperator;
import javax.swing.JTextField;
import org.pendant.kit.layout.Typed;

/**
 * Typed field of a form. What is typed is taken at once if it can be; otherwise it stays red until
 * it is put right, and the program keeps what it had.
 */
@SuppressWarnings("serial") // never written to a stream
final class TypedField extends JTextField {
  private final transient UnaryOperator<String> type;
  private final transient UnaryOperator<String> canonical;
  private final transient Runnable refused;
  private String shown = "";
  private String refusal = "";
  private boolean showing;

  /**
   * An empty field.
   *
   * @param type takes a text and says why it cannot; empty if it can
   * @param canonical the same value as it is usually written
   * @param refused told when what is wrong with the text changes
   */
  TypedField(
      int columns, UnaryOperator<String> type, UnaryOperator<String> canonical, Runnable refused) {
    super(columns);
    this.type = type;
    this.canonical = canonical;
    this.refused = refused;
    getDocument().addDocumentListener(new Typed(this::typed));
    FieldKeys.listen(this, this::tidy);
  }

  private void typed() {
    if (!showing) {
      String why = type.apply(getText());
      if (why.isEmpty()) {
        shown = canonical.apply(getText());
      }
      setRefusal(why);
    }
  }

  private void setRefusal(String why) {
    if (!why.equals(refusal)) {
      refusal = why;
      refused.run();
    }
  }

  /** Why what is in the field cannot be taken; empty if it can. */
  String refusal() {
    return refusal;
  }

  private void tidy() {
    if (refusal.isEmpty() && !getText().equals(shown)) {
      show(shown, true);
    }
  }

  /** Shows a value; a text that means the same stays, and so does a refused one for the same. */
  void follow(String value) {
    boolean typing = !refusal.isEmpty() && value.equals(shown);
    boolean same = refusal.isEmpty() && canonical.apply(getText()).equals(value);
    shown = value;
    if (!typing && (!same || !isFocusOwner())) {
      show(value, false);
    }
  }

  private void show(String value, boolean caretToEnd) {
    if (!getText().equals(value)) {
      showing = true;
      int caret = getCaretPosition();
      setText(value);
      setCaretPosition(caretToEnd ? value.length() : Math.min(caret, value.length()));
      showing = false;
    }
    setRefusal("");
  }

  /** Marks it as wrong, or not. */
  void outline(boolean wrong) {
    Object outline = wrong ? "error" : null;
    if (!Objects.equals(getClientProperty("JComponent.outline"), outline)) {
      putClientProperty("JComponent.outline", outline);
    }
  }
}
