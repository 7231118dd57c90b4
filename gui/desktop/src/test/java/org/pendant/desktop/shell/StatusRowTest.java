package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;

final class StatusRowTest {
  private final JLabel past = new JLabel();
  private final JLabel status = new JLabel();

  private void say(boolean back, String banner, String told) throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          StatusRow row = new StatusRow(past, status);
          past.setVisible(back);
          past.setText(banner);
          status.setText(told);
          row.setSize(1200, 40);
          row.doLayout();
        });
  }

  @Test
  void whatWasToldHasTheWholeRowWhileNobodyLooksBack() throws Exception {
    say(false, "", "Saved");
    assertEquals(0, status.getX());
    assertEquals(1200, status.getWidth());
  }

  @Test
  void itStaysWhereItIsWhenPeopleLookBackWhateverIsSaid() throws Exception {
    say(true, "Looking at 1 s", "");
    int line = past.getX();
    assertEquals(0, status.getX());
    assertEquals(435, line, 2);
    say(true, "Looking at 1111.000 s", "A long sentence of what was told last. ".repeat(5));
    assertEquals(0, status.getX());
    assertEquals(line, past.getX());
  }
}
