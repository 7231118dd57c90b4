package org.pendant.kit.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.BorderLayout;
import java.awt.Dimension;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class WideContentTest {
  private final JPanel card = new JPanel();
  private final WideContent content = new WideContent(new BorderLayout());
  private final JScrollPane scroll = new SettledScroll(content);

  private int widthAt(int height) {
    scroll.setSize(300, height);
    Parts.layOut(scroll);
    return card.getWidth();
  }

  @Test
  void whatItHasIsAsWideWithAScrollBarAsWithout() {
    card.setPreferredSize(new Dimension(100, 200));
    content.add(card);
    int high = widthAt(400);
    assertFalse(scroll.getVerticalScrollBar().isVisible());
    int low = widthAt(100);
    assertTrue(scroll.getVerticalScrollBar().isVisible());
    assertEquals(high, low);
    assertEquals(high, widthAt(400));
  }
}
