package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Variables in a table, in no window. */
final class ValueTableTest {
  private final DebugFixture fixture =
      new DebugFixture(
          "def program():",
          "  global ACCELERATION_MAX = 1.25",
          "  global i = p[0.1, 0.2, 0.3, 0, 3.14159, 0]",
          "  sync()",
          "end");

  @BeforeEach
  void needADisplay() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "values are dragged, which needs a display");
  }

  private int shortOf(int tableWidth) throws Exception {
    int[] missing = {0};
    EventQueue.invokeAndWait(
        () -> {
          ValueTree tree = fixture.debug().variables();
          ValueTable table =
              new ValueTable("values", tree, false, (row, name) -> {}, Optional.of(row -> {}));
          table.setSize(tableWidth, 300);
          table.doLayout();
          for (int i = 0; i < table.getRowCount(); i++) {
            if (table.row(i) instanceof ValueRow.Value value
                && value.name().equals("ACCELERATION_MAX")) {
              Component name = table.prepareRenderer(table.getCellRenderer(i, 0), i, 0);
              missing[0] = name.getPreferredSize().width - table.getCellRect(i, 0, false).width;
              return;
            }
          }
          throw new AssertionError("the variable is not shown");
        });
    return missing[0];
  }

  @Test
  void namesOfSixteenLettersAreWholeInANarrowPanel() throws Exception {
    fixture.breakAt(4);
    fixture.run();
    for (int width : new int[] {320, 360, 480, 900}) {
      int missing = shortOf(width);
      assertTrue(missing <= 0, "of " + width + " pixels " + missing + " are missing");
    }
  }

  @Test
  void valuesKeepAPartOfATableThatIsNarrowerStill() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          ValueTable table =
              new ValueTable(
                  "values",
                  fixture.debug().variables(),
                  false,
                  (row, name) -> {},
                  Optional.of(row -> {}));
          table.setSize(160, 300);
          table.doLayout();
          // What is left over goes to columns by their fonts: names insist on no more than the
          // half.
          int names = table.getColumnModel().getColumn(ValueTableModel.NAME).getMinWidth();
          int values = table.getColumnModel().getColumn(ValueTableModel.VALUE).getWidth();
          assertTrue(names <= 80, () -> "names: " + names);
          assertTrue(values >= 20, () -> "values: " + values);
        });
  }
}
