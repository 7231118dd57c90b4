package org.pendant.kit.form;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.event.FocusEvent;
import java.util.List;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class TabSelectionTest {
  /** What is typed over a "120" whose field got the focus in a way. */
  private static String typed(FocusEvent.Cause cause) {
    JTextField field = new EntryField(7, text -> "", text -> {});
    field.setText("120");
    field.setCaretPosition(0);
    FocusEvent gained = new FocusEvent(field, FocusEvent.FOCUS_GAINED, false, null, cause);
    List.of(field.getFocusListeners()).forEach(each -> each.focusGained(gained));
    field.replaceSelection("250");
    return field.getText();
  }

  @Test
  void whatIsTypedAfterTabTakesThePlaceOfTheNumber() {
    assertEquals("250", typed(FocusEvent.Cause.TRAVERSAL_FORWARD));
    assertEquals("250", typed(FocusEvent.Cause.TRAVERSAL_BACKWARD));
  }

  @Test
  void aClickPutsTheCaretIntoTheNumber() {
    assertEquals("250120", typed(FocusEvent.Cause.MOUSE_EVENT));
  }
}
