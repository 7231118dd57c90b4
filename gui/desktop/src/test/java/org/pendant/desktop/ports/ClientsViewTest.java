package org.pendant.desktop.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.FontMetrics;
import java.nio.file.Path;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.layout.Parts;
import org.pendant.kit.theme.PreviewLook;

/** The screen, in no window. */
final class ClientsViewTest {
  /** What is left beside the 3D view in a window 1024 wide. */
  private static final int WIDTH = 600;

  @TempDir Path folder;

  @Test
  void timesOfManyHoursAndKindsOfMessagesAreWholeOnANarrowScreen() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      EventQueue.invokeAndWait(
          () -> {
            PreviewLook.install(false);
            DesktopPorts ports = new DesktopPorts(session, folder, visit -> {});
            ClientsView view = new ClientsView(new PreviewWorkbench(), ports, timeS -> {});
            view.component().setSize(WIDTH, 500);
            Parts.layOut(view.component());
            Parts.layOut(view.component());
            JTable table = (JTable) Parts.named(view.component(), "clients-messages");

            assertEquals(WIDTH, table.getWidth(), 20, "nothing is beyond the edge");
            hasRoom(table, "Time", "86399.998");
            hasRoom(table, "Type", "protocol-version");
          });
    }
  }

  private static void hasRoom(JTable table, String column, String words) {
    FontMetrics metrics = table.getFontMetrics(table.getFont());
    int room = table.getColumn(column).getWidth();
    assertTrue(metrics.stringWidth(words) + 6 <= room, () -> words + " in " + room);
  }
}
