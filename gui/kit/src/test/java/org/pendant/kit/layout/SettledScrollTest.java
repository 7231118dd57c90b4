package org.pendant.kit.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.EventQueue;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import org.junit.jupiter.api.Test;

final class SettledScrollTest {
  @Test
  void whatIsBelowAWrappedTextIsInItsPlaceAfterTheFirstLayout() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          JTextArea text =
              new JTextArea("Where the joints are at the pose that was typed. ".repeat(4));
          text.setLineWrap(true);
          text.setWrapStyleWord(true);
          text.setColumns(10);
          JLabel below = new JLabel("below");
          TitledCard card = new TitledCard("text", "Text", "[grow, fill]");
          card.add(text, "growx, width 0:10:");
          below.setPreferredSize(new Dimension(330, 20));
          card.add(below);
          WideContent sheet = new WideContent(new CardColumns(8, 500));
          sheet.add(card);
          SettledScroll scroll = new SettledScroll(sheet);
          scroll.setSize(420, 400);
          scroll.addNotify();
          scroll.validate();
          assertTrue(text.getWidth() > 300, "width " + text.getWidth());
          assertEquals(text.getPreferredSize().height, text.getHeight());
          assertTrue(below.getY() < text.getY() + text.getHeight() + 12, "below: " + below.getY());
        });
  }
}
