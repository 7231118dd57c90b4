package org.pendant.kit.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Dimension;
import java.awt.event.MouseWheelEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import org.junit.jupiter.api.Test;

final class InnerScrollTest {
  private final JScrollPane inner = InnerScroll.of(new JScrollPane(panel(400)));
  private final JScrollPane sheet = new JScrollPane(inner);
  private final List<Integer> passedOn = new ArrayList<>();

  private InnerScrollTest() {
    inner.setSize(100, 100);
    inner.doLayout();
    inner.getVerticalScrollBar().setValues(0, 100, 0, 400);
    sheet.addMouseWheelListener(event -> passedOn.add(event.getWheelRotation()));
  }

  private static JPanel panel(int height) {
    JPanel panel = new JPanel();
    panel.setPreferredSize(new Dimension(50, height));
    return panel;
  }

  private void turn(int rotation) {
    inner.dispatchEvent(
        new MouseWheelEvent(
            inner,
            MouseWheelEvent.MOUSE_WHEEL,
            0,
            0,
            10,
            10,
            0,
            false,
            MouseWheelEvent.WHEEL_UNIT_SCROLL,
            3,
            rotation));
  }

  @Test
  void theSheetScrollsWhereThePaneIsAtItsEnd() {
    turn(1);
    assertEquals(List.of(), passedOn);
    inner.getVerticalScrollBar().setValue(0);
    turn(-1);
    assertEquals(List.of(-1), passedOn);
    inner.getVerticalScrollBar().setValue(300);
    turn(1);
    assertEquals(List.of(-1, 1), passedOn);
  }
}
