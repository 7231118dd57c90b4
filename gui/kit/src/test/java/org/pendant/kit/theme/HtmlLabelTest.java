package org.pendant.kit.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.awt.EventQueue;
import javax.swing.JPanel;
import javax.swing.plaf.basic.BasicHTML;
import org.junit.jupiter.api.Test;

final class HtmlLabelTest {
  @Test
  void htmlIsReadWhenTheLabelIsInAWindowAndChangesFromThenOn() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          HtmlLabel label = new HtmlLabel();
          label.setText("<html>one<br>two");
          assertNull(label.getClientProperty(BasicHTML.propertyKey));
          assertEquals("<html>one<br>two", label.getText());
          JPanel window = new JPanel();
          window.add(label);
          int lineHeight = label.getPreferredSize().height;
          window.addNotify();
          Object read = label.getClientProperty(BasicHTML.propertyKey);
          assertNotNull(read);
          assertEquals(2 * lineHeight, label.getPreferredSize().height, 0.5 * lineHeight);
          label.setText("<html>three");
          assertNotNull(label.getClientProperty(BasicHTML.propertyKey));
          assertEquals(lineHeight, label.getPreferredSize().height, 0.5 * lineHeight);
        });
  }
}
