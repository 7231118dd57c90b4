package org.pendant.kit.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Dimension;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class WrappingRowTest {
  private final JPanel row = new JPanel(new WrappingRow(4));

  private Component add(int width) {
    JPanel part = new JPanel();
    part.setPreferredSize(new Dimension(width, 20));
    row.add(part);
    return part;
  }

  private void layOut(int width) {
    row.setSize(width, 20);
    row.doLayout();
  }

  @Test
  void whatDoesNotFitBeginsANewRow() {
    Component first = add(100);
    Component second = add(100);
    layOut(212);
    assertEquals(first.getY(), second.getY());
    layOut(211);
    assertTrue(second.getY() > first.getY());
    assertEquals(first.getX(), second.getX());
    assertEquals(52, row.getPreferredSize().height);
  }

  @Test
  void nothingReachesBeyondTheEdge() {
    Component wide = add(500);
    Component other = add(50);
    layOut(309);
    assertEquals(301, wide.getWidth());
    assertTrue(other.getX() + other.getWidth() <= 309 - 4);
    assertTrue(row.getPreferredSize().width <= 309);
  }

  @Test
  void whatBelongsTogetherBeginsANewRowTogether() {
    add(100);
    JPanel up = new JPanel();
    JPanel down = new JPanel();
    up.setPreferredSize(new Dimension(40, 20));
    down.setPreferredSize(new Dimension(40, 20));
    JPanel both = WrappingRow.together(4, up, down);
    row.add(both);
    layOut(170);
    both.doLayout();
    assertEquals(up.getY(), down.getY());
    assertEquals(28, both.getY());
  }
}
