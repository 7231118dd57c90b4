package org.pendant.desktop.tests;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.swing.JPanel;
import javax.swing.JRootPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;

final class TestsViewTest {
  private final JRootPane window = new JRootPane();
  private final JPanel dock = new JPanel();
  private final JPanel view = new JPanel();
  private final JTextField elsewhere = new JTextField();

  @Test
  void keysThatGoAroundTheViewAreMeantForIt() {
    window.getContentPane().add(dock);
    dock.add(view);
    assertTrue(TestsView.isAround(view, view));
    assertTrue(TestsView.isAround(dock, view));
    assertFalse(TestsView.isAround(elsewhere, view));
    assertFalse(TestsView.isAround(null, view));
  }

  @Test
  void keysOfAnOpenMenuAreLeftToIt() {
    window.getContentPane().add(dock);
    dock.add(view);
    assertFalse(TestsView.isAround(window, view));
  }
}
