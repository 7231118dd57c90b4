package org.pendant.desktop.program.form;

import javax.swing.JComponent;

/** Field view: shows one item of a form and hands on what people do with it. */
interface FieldView {

  /** The control, or all of them. */
  JComponent component();

  /** What gets the focus; the same as {@link #component} or in it. */
  default JComponent focus() {
    return component();
  }

  /** Shows the item as it is now, without disturbing a user who types the same. */
  void show(Item item);

  /** Says what is wrong with it; empty for nothing. */
  default void setProblem(String problem) {}
}
