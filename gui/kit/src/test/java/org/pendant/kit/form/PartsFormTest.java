package org.pendant.kit.form;

import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.swing.JComponent;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class PartsFormTest {
  @Test
  void aFormThatWasWideBecomesNarrowAgainWithItsNotes() {
    PartsForm<String> form = new PartsForm<>("joints", value -> "", value -> {});
    form.note(() -> "In deg/s and deg; none: no limit but that of the arm.");
    JComponent component = form.component();
    component.setSize(640, 100);
    component.doLayout();
    assertTrue(component.getMinimumSize().width < 200, component::toString);
  }
}
