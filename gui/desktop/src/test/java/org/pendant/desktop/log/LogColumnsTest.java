package org.pendant.desktop.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;

final class LogColumnsTest {
  private final Map<String, String> remembered = new HashMap<>();
  private final Settings settings = new MemorySettings(remembered);
  private final LogColumns columns = new LogColumns(settings);

  private List<LogColumns.Shown> fit(int width) {
    return columns.fit(width, 300, column -> 80, 30);
  }

  private List<LogColumn> shown(int width) {
    return fit(width).stream().map(LogColumns.Shown::column).toList();
  }

  @Test
  void theMessageGetsWhatTheOthersLeave() {
    List<LogColumns.Shown> wide = fit(1000);
    assertEquals(7, wide.size());
    assertEquals(new LogColumns.Shown(LogColumn.MESSAGE, 1000 - 6 * 80, false), wide.getLast());
  }

  @Test
  void whereThereIsLittleRoomOthersGoFirst() {
    assertEquals(
        List.of(
            LogColumn.TIME,
            LogColumn.SEVERITY,
            LogColumn.SOURCE,
            LogColumn.CODE,
            LogColumn.LINE,
            LogColumn.MESSAGE),
        shown(700));
    assertTrue(fit(700).get(1).compact(), "a symbol says the same");
    assertEquals(
        List.of(LogColumn.TIME, LogColumn.SEVERITY, LogColumn.LINE, LogColumn.MESSAGE), shown(200));
    assertEquals(100, fit(200).getLast().width());
  }

  @Test
  void whatPeopleChooseIsKept() {
    assertFalse(columns.wanted(LogColumn.WALL_TIME));
    columns.want(LogColumn.WALL_TIME, true);
    columns.want(LogColumn.SOURCE, false);
    LogColumns next = new LogColumns(settings);
    assertTrue(next.wanted(LogColumn.WALL_TIME));
    assertFalse(next.wanted(LogColumn.SOURCE));
    columns.want(LogColumn.SOURCE, true);
    assertTrue(new LogColumns(settings).wanted(LogColumn.SOURCE));
  }
}
