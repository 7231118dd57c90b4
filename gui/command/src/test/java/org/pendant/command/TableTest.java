package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

final class TableTest {

  private static Table twoRows() {
    Table table = new Table().left("name").right("kg").left("note");
    table.row("a", "12.5", "heavy");
    table.row("longer", "3", "");
    return table;
  }

  @Test
  void columnsAreAsWideAsTheirWidestCellAndNumbersStandOnTheRight() {
    assertEquals(
        List.of(
            "name      kg  note", //
            "a       12.5  heavy",
            "longer     3"),
        twoRows().aligned());
  }

  @Test
  void columnsStandBelowEachOtherOnATerminalWhereChineseCharactersAreTwoColumnsWide() {
    Table table = new Table().left("结果").right("次数");
    table.row("ok", "12");
    table.row("失败", "3");
    assertEquals(List.of("结果  次数", "ok      12", "失败     3"), table.aligned());
  }

  @Test
  void markdownTellsTheAlignmentToo() {
    assertEquals(
        List.of(
            "| name | kg | note |",
            "| --- | ---: | --- |",
            "| a | 12.5 | heavy |",
            "| longer | 3 |  |"),
        twoRows().markdown());
  }

  @Test
  void rowsOfAnotherLengthAreRefused() {
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> twoRows().row("a", "1"));
    assertEquals("row has 2 cells, must have 3", refused.getMessage());
  }
}
