package org.pendant.kit.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JInternalFrame;
import javax.swing.RepaintManager;
import org.junit.jupiter.api.Test;

/** What a window paints again after another one has covered it. */
class UncoveredEdgesTest {

  @Test
  void thePartAndOnePointAroundItIsPaintedAgain() throws Exception {
    List<Rectangle> asked = new ArrayList<>();
    EventQueue.invokeAndWait(
        () -> {
          JInternalFrame window = new JInternalFrame();
          window.getRootPane().setBounds(0, 20, 400, 300);
          RepaintManager before = RepaintManager.currentManager(window);
          RepaintManager.setCurrentManager(
              new RepaintManager() {
                @Override
                public void addDirtyRegion(JComponent part, int x, int y, int width, int height) {
                  asked.add(new Rectangle(x, y, width, height));
                }
              });
          try {
            UncoveredEdges.repaint(window, new Rectangle(100, 50, 200, 120));
          } finally {
            RepaintManager.setCurrentManager(before);
          }
        });
    assertEquals(List.of(new Rectangle(99, 29, 202, 122)), asked);
  }
}
