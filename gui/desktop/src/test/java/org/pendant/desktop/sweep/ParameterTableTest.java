package org.pendant.desktop.sweep;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.FontMetrics;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.kit.background.Background;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class ParameterTableTest {
  private static final int WHAT = 1;
  private static final int NOW = 2;
  private static final int VALUES = 6;
  private static final int LEFT_FOR_WHAT = 100;

  @TempDir private Path folder;

  /** Everything at once, in this thread. */
  private static final class AtOnce implements SweepPresenter.Elsewhere {
    @Override
    public <T> void run(Background.Task<T> task, Consumer<T> then, Consumer<IOException> failed) {
      try {
        then.accept(task.run());
      } catch (IOException e) {
        failed.accept(e);
      }
    }
  }

  @Test
  void numbersAndNamesOfColumnsAreWholeWhereTheTableIsNarrow() throws IOException {
    Path script = folder.resolve("nap.script");
    Files.writeString(
        script,
        "def nap():\n  PART_PRESENT = 0.5\n  home = [0, -1.5708, -1.5708, 0, 0, 0]\n"
            + "  movej(home)\n  sleep(PART_PRESENT)\nend\n");
    FlatLaf.setup(new FlatLightLaf());
    SweepPresenter presenter =
        new SweepPresenter(
            () ->
                new SweepSubject(
                    "nap.script",
                    Optional.of(script),
                    Optional.empty(),
                    Optional.empty(),
                    "ur5e",
                    List.of()),
            new AtOnce(),
            text -> {},
            file -> {});
    presenter.planThis();
    ParameterTable table = new ParameterTable(presenter);
    table.showDraft();
    int others = 0;
    for (int column = 0; column < table.getColumnCount(); column++) {
      others += column == WHAT ? 0 : table.getColumnModel().getColumn(column).getPreferredWidth();
    }
    table.setSize(others + LEFT_FOR_WHAT, 300);
    table.doLayout();

    FontMetrics metrics = table.getFontMetrics(table.getFont());
    for (int column = 0; column < table.getColumnCount(); column++) {
      boolean whole = column >= NOW && column != VALUES;
      for (int row = 0; whole && row < table.getRowCount(); row++) {
        String text = String.valueOf(table.getValueAt(row, column));
        int room = table.getColumnModel().getColumn(column).getWidth();
        assertTrue(metrics.stringWidth(text) < room, text + " in " + room);
      }
    }
    assertEquals(LEFT_FOR_WHAT, table.getColumnModel().getColumn(WHAT).getWidth());
  }
}
