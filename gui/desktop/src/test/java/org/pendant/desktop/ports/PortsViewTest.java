package org.pendant.desktop.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.Point;
import java.awt.event.ActionEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JViewport;
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

  @Test
  void upBeginsAtTheLastPort() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      DesktopPorts ports = new DesktopPorts(session, folder, visit -> {});
      ports.want(Optional.of(FreePorts.wishes(folder)));
      EventQueue.invokeAndWait(
          () -> {
            PortsView view = new PortsView(new PreviewWorkbench(), ports);
            JTable table = (JTable) Parts.named(view.component(), "ports-table");
            String up = "selectPreviousRow";
            ActionEvent pressed = new ActionEvent(table, ActionEvent.ACTION_PERFORMED, up);
            table.getActionMap().get(up).actionPerformed(pressed);
            assertEquals(table.getRowCount() - 1, table.getSelectedRow());
          });
    }
  }

  @Test
  void whatIsSaidOfPortsDoesNotScrollTheSwitchOutOfALowPanel() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      DesktopPorts ports = new DesktopPorts(session, folder, visit -> {});
      AtomicReference<JTextArea> summary = new AtomicReference<>();
      EventQueue.invokeAndWait(
          () -> {
            PortsView view = new PortsView(new PreviewWorkbench(), ports);
            layOut(view, 100);
            summary.set((JTextArea) Parts.named(view.component(), "ports-summary"));
            summary.get().setText("Closed. Open them, and others reach this controller.");
          });
      EventQueue.invokeAndWait(
          () -> {
            JViewport seen =
                (JViewport) SwingUtilities.getAncestorOfClass(JViewport.class, summary.get());
            assertEquals(new Point(0, 0), seen.getViewPosition());
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
