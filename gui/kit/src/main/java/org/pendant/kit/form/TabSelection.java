package org.pendant.kit.form;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.EnumSet;
import java.util.Set;
import javax.swing.JTextField;

/**
 * Tab selection: a field that Tab goes to has its text selected, so that what is typed takes the
 * place of what is there. A click puts the caret where it is meant.
 */
public final class TabSelection {
  private static final Set<FocusEvent.Cause> BY_TAB =
      EnumSet.of(FocusEvent.Cause.TRAVERSAL_FORWARD, FocusEvent.Cause.TRAVERSAL_BACKWARD);

  private TabSelection() {}

  /** Has Tab select what is in {@code field}. */
  public static <F extends JTextField> F of(F field) {
    field.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            if (!event.isTemporary() && BY_TAB.contains(event.getCause())) {
              field.selectAll();
            }
          }
        });
    return field;
  }
}
