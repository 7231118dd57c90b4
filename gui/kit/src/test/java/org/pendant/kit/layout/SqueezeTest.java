package org.pendant.kit.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class SqueezeTest {
  private final JPanel row = new JPanel(new MigLayout("insets 0, gap 0, hidemode 3"));
  private final JPanel clock = part();
  private final JPanel slider = part();
  private final JPanel stop = part();
  private final Squeeze squeeze = new Squeeze(row, List.of(clock::setVisible, slider::setVisible));

  private JPanel part() {
    JPanel part = new JPanel();
    row.add(part, "w 100px!, h 10px!");
    return part;
  }

  private String shownAt(int width) {
    row.setSize(width, 10);
    squeeze.fit();
    return (clock.isVisible() ? "clock " : "")
        + (slider.isVisible() ? "slider " : "")
        + (stop.isVisible() ? "stop" : "");
  }

  @Test
  void theLeastImportantGoesFirstAndComesBackLast() {
    assertEquals("clock slider stop", shownAt(300));
    assertEquals("slider stop", shownAt(299));
    assertEquals("stop", shownAt(199));
    assertEquals("stop", shownAt(50));
    assertEquals("slider stop", shownAt(200));
    assertEquals("clock slider stop", shownAt(1000));
  }
}
