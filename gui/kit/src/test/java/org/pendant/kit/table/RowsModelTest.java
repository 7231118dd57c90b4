package org.pendant.kit.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

final class RowsModelTest {
  private final Letters letters = new Letters();
  private final List<String> told = new ArrayList<>();

  /** A word in a row: as it is, and how long. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Letters extends RowsModel<String> {
    Letters() {
      super(List.of("Word", "Letters"));
    }

    @Override
    protected Object cell(String row, int column) {
      return column == 0 ? row : row.length();
    }
  }

  @BeforeEach
  void listen() {
    letters.show(List.of("one", "three"));
    letters.addTableModelListener(
        event ->
            told.add(
                event.getLastRow() == Integer.MAX_VALUE
                    ? "all"
                    : event.getFirstRow() + " to " + event.getLastRow()));
  }

  @Test
  void eachRowHasACellForEachTitle() {
    assertEquals(2, letters.getRowCount());
    assertEquals(2, letters.getColumnCount());
    assertEquals("Letters", letters.getColumnName(1));
    assertEquals(5, letters.getValueAt(1, 1));
  }

  @Test
  void onlyRowsThatDifferAreTold() {
    assertFalse(letters.show(List.of("one", "two")));
    assertEquals(List.of("1 to 1"), told);
  }

  @Test
  void anotherNumberOfRowsIsAnotherTable() {
    assertTrue(letters.show(List.of("one")));
    assertEquals(List.of("all"), told);
  }

  @Test
  void rowsOfSomethingElseReplaceThoseBefore() {
    assertFalse(letters.replace(List.of("one", "three")));
    assertEquals(List.of(), told);
    assertTrue(letters.replace(List.of("one", "two")));
    assertEquals(List.of("all"), told);
  }
}
