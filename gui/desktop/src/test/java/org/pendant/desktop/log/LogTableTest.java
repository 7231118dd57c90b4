package org.pendant.desktop.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.kit.settings.MemorySettings;

/** The table of messages, in no window. */
final class LogTableTest {
  /** Settings that keep nothing. */
  private final List<LogLine> written = new ArrayList<>();

  private final LogPresenter presenter = new LogPresenter(1000);

  private void say(LogTable table, int count) {
    for (int i = 0; i < count; i++) {
      write("message " + (written.size() + 1));
    }
    take(table);
  }

  private void write(String text) {
    long number = written.size() + 1L;
    LogEntry entry = new LogEntry(number, 0.5, Level.INFO, Origin.SCRIPT, text);
    written.add(LogLine.of(number, Instant.EPOCH, LogSource.of(Origin.SCRIPT), entry));
  }

  private void take(LogTable table) {
    table.changed(
        presenter.take(
            written.size(), number -> List.copyOf(written.subList((int) number, written.size()))));
  }

  @Test
  void messageThatIsClickedStaysWhereItIsWhileOthersCome() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "clicks ask the display for its keys");
    EventQueue.invokeAndWait(
        () -> {
          LogTable table =
              new LogTable(presenter, new LogColumns(new MemorySettings()), () -> {}, line -> {});
          table.component().setSize(600, 200);
          say(table, 100);
          layOut(table.component());
          JTable rows = find(table.component()).orElseThrow();
          assertTrue(presenter.following());

          click(rows, 95);
          say(table, 20);

          assertEquals(95, table.selectedRow());
          assertFalse(presenter.following());
          click(rows, presenter.rows() - 1);
          assertFalse(presenter.following(), "only people who scroll to the end want to follow");
        });
  }

  @Test
  void messageThatIsCutHasAllItsWordsInItsToolTip() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          LogTable table =
              new LogTable(presenter, new LogColumns(new MemorySettings()), () -> {}, line -> {});
          table.component().setSize(420, 200);
          write("Program pick_and_place of the tray at the left has finished. ".repeat(20) + "End");
          write("short");
          write("first line\nsecond line\nthird line\nfourth line\nfifth line");
          take(table);
          layOut(table.component());
          layOut(table.component());
          JTable rows = find(table.component()).orElseThrow();

          assertTrue(String.valueOf(toolTip(rows, 0)).contains("End"));
          assertEquals("null", String.valueOf(toolTip(rows, 1)));
          assertTrue(String.valueOf(toolTip(rows, 2)).contains("fifth line"));
        });
  }

  @Test
  void informationHasTheLinesThatItNeedsUpToFour() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          LogTable table =
              new LogTable(presenter, new LogColumns(new MemorySettings()), () -> {}, line -> {});
          table.component().setSize(420, 200);
          write("short");
          write("Program pick_and_place of the tray at the left has finished after 4.25 s");
          write("first line\nsecond line\nthird line");
          write("1\n2\n3\n4\n5\n6\n7");
          layOut(table.component());
          layOut(table.component());
          take(table);
          JTable rows = find(table.component()).orElseThrow();

          int line = rows.getFontMetrics(rows.getFont()).getHeight();
          int one = rows.getRowHeight(0);
          assertTrue(rows.getRowHeight(1) >= one + line, "all words in sight");
          assertEquals("null", String.valueOf(toolTip(rows, 1)));
          assertEquals(one + 2 * line, rows.getRowHeight(2));
          assertEquals(one + 3 * line, rows.getRowHeight(3));
        });
  }

  private static String toolTip(JTable rows, int row) {
    Rectangle cell = rows.getCellRect(row, rows.getColumnCount() - 1, false);
    int x = (int) cell.getCenterX();
    int y = (int) cell.getCenterY();
    return rows.getToolTipText(new MouseEvent(rows, MouseEvent.MOUSE_MOVED, 0, 0, x, y, 0, false));
  }

  private static void click(JTable rows, int row) {
    Rectangle cell = rows.getCellRect(row, 1, false);
    rows.dispatchEvent(
        new MouseEvent(
            rows,
            MouseEvent.MOUSE_PRESSED,
            0,
            InputEvent.BUTTON1_DOWN_MASK,
            (int) cell.getCenterX(),
            (int) cell.getCenterY(),
            1,
            false,
            MouseEvent.BUTTON1));
  }

  private static void layOut(Container in) {
    in.doLayout();
    Stream.of(in.getComponents())
        .filter(Container.class::isInstance)
        .forEach(each -> layOut((Container) each));
  }

  private static Optional<JTable> find(Component in) {
    if (in instanceof JTable table) {
      return Optional.of(table);
    }
    return in instanceof Container inner
        ? Stream.of(inner.getComponents()).flatMap(each -> find(each).stream()).findFirst()
        : Optional.empty();
  }
}
