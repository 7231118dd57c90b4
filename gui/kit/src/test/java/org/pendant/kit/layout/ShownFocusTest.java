package org.pendant.kit.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Rectangle;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;

final class ShownFocusTest {
  @Test
  void keysBringAFieldIntoSight() {
    List<Rectangle> shown = new ArrayList<>();
    JPanel around =
        new JPanel(null) {
          private static final long serialVersionUID = 1L;

          @Override
          public void scrollRectToVisible(Rectangle wanted) {
            shown.add(wanted);
          }
        };
    JLabel field = ShownFocus.of(new JLabel());
    around.add(field);
    field.setBounds(10, 900, 80, 20);
    FocusEvent gained = new FocusEvent(field, FocusEvent.FOCUS_GAINED);
    List.of(field.getFocusListeners()).forEach(each -> each.focusGained(gained));
    assertEquals(List.of(new Rectangle(10, 900, 80, 20)), shown);
  }
}
