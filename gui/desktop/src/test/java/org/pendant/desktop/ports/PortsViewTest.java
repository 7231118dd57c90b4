package org.pendant.desktop.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.layout.Parts;

/** The panel, in no window. */
final class PortsViewTest {
  private static final int WIDTH = 440;

  @TempDir Path folder;

  @Test
  void aLowPanelScrollsAsAWholeRatherThanHalfARowInIt() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      DesktopPorts ports = new DesktopPorts(session, folder, visit -> {});
      ports.want(Optional.of(FreePorts.wishes(folder)));
      EventQueue.invokeAndWait(
          () -> {
            PortsView view = new PortsView(new PreviewWorkbench(), ports);
            JTable table = (JTable) Parts.named(view.component(), "ports-table");
            assertTrue(table.getRowCount() > 5, () -> table.getRowCount() + " rows");
            layOut(view, 280);
            assertEquals(table.getPreferredSize().height, table.getParent().getHeight());

            layOut(view, 1200);
            int end = SwingUtilities.convertPoint(table, 0, table.getHeight(), view.component()).y;
            assertTrue(end > 1150 && end <= 1200, () -> "the table ends at " + end);
          });
    }
  }

  private static void layOut(PortsView view, int height) {
    view.component().setSize(WIDTH, height);
    // once more, with the texts as wide as they are now
    Parts.layOut(view.component());
    Parts.layOut(view.component());
  }
}
