package org.pendant.kit.form;

import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.AbstractAction;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import org.pendant.kit.layout.Typed;

/**
 * Entry field: a field whose text is checked while it is typed, and taken by Enter or when the
 * focus leaves. Escape brings back what was there.
 */
@SuppressWarnings("serial") // never written to a stream
public final class EntryField extends JTextField {
  private final transient UnaryOperator<String> check;
  private final transient Consumer<String> take;
  private transient Runnable refused = () -> {};
  private transient Runnable nothing = () -> {};
  private String shown = "";
  private String refusal = "";
  private String tip = "";
  private boolean showing;

  /**
   * An empty field.
   *
   * @param check why a text cannot be taken; empty if it can
   * @param take takes a text that can be
   */
  public EntryField(int columns, UnaryOperator<String> check, Consumer<String> take) {
    super(columns);
    this.check = check;
    this.take = take;
    getDocument().addDocumentListener(new Typed(this::typed));
    addActionListener(event -> commit());
    TabSelection.of(this);
    addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            commit();
          }
        });
    getInputMap().put(KeyStroke.getKeyStroke("ESCAPE"), "as-it-was");
    getActionMap()
        .put(
            "as-it-was",
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                show(shown);
              }
            });
  }

  /** What it is for, while nothing is wrong. */
  public EntryField withTip(String text) {
    tip = text;
    if (refusal.isEmpty()) {
      setToolTipText(text);
    }
    return this;
  }

  /** Runs when what is wrong with the text changes. */
  public void whenRefused(Runnable listener) {
    refused = listener;
  }

  /** Runs whenever nothing is typed that could be taken. */
  public void whenNothing(Runnable listener) {
    nothing = listener;
  }

  private void typed() {
    if (!showing) {
      boolean same = getText().equals(shown);
      setRefusal(same ? "" : check.apply(getText()));
      if (same || !refusal.isEmpty()) {
        nothing.run();
      }
    }
  }

  private void setRefusal(String why) {
    if (!why.equals(refusal)) {
      refusal = why;
      putClientProperty("JComponent.outline", why.isEmpty() ? null : "error");
      setToolTipText(why.isEmpty() ? tip : why);
      getAccessibleContext().setAccessibleDescription(why);
      refused.run();
    }
  }

  /** Why what is in the field cannot be taken; empty if it can. */
  public String refusal() {
    return refusal;
  }

  /** Takes what was typed, if it can be taken. */
  private void commit() {
    String text = getText();
    if (showing || !refusal.isEmpty() || text.equals(shown)) {
      return;
    }
    shown = text;
    take.accept(text);
  }

  /** Shows a value; what the user is typing in place of the same one stays. */
  public void follow(String value) {
    boolean typing = !getText().equals(shown);
    if (!Objects.equals(value, shown) || (!typing && !getText().equals(value))) {
      show(value);
    }
  }

  /** Shows a value, whatever the user has typed. */
  public void show(String value) {
    shown = value;
    if (!getText().equals(value)) {
      showing = true;
      setText(value);
      setCaretPosition(0);
      showing = false;
      nothing.run();
    }
    setRefusal("");
  }
}
