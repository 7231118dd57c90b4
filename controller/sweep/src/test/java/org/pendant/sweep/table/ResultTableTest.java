package org.pendant.sweep.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.PlanReader;
import org.pendant.sweep.plan.SweepPlan;

final class ResultTableTest {
  static final String PLAN =
      """
      program = "a.script"
      variables = ["n"]
      [sampling]
      method = "random"
      runs = 12
      [[parameter]]
      name = "speed"
      set = "speed"
      from = 0.1
      to = 1
      [[parameter]]
      name = "duration"
      set = "variable where"
      values = ["p[0, 0, 0, 0, 0, 0]"]
      """;

  private static SweepPlan plan() throws PlanException {
    return PlanReader.read("p.toml", PLAN);
  }

  @Test
  void columnsAreTheNumberTheParametersAndTheResults() throws PlanException {
    List<ResultColumn> columns = ResultTable.of(plan()).columns();
    List<String> names = columns.stream().map(ResultColumn::name).toList();
    assertEquals(
        List.of("run", "speed", "duration", "outcome", "reason", "line", "duration_2"),
        names.subList(0, 7));
    assertEquals(new HashSet<>(names).size(), names.size());
    assertEquals("var_n", names.getLast());
    assertEquals(CellType.TEXT, columns.get(2).type());
  }

  @Test
  void rowReadsBackAsItWasWritten() throws PlanException {
    SweepPlan plan = plan();
    ResultTable table = ResultTable.of(plan);
    for (long i = 0; i < plan.size(); i++) {
      List<java.util.Optional<Object>> row = table.row(SomeResults.of(plan.variant(i)));
      String line = CsvRows.row(row);
      assertTrue(line.endsWith("\n"));
      assertEquals(
          row.stream().map(each -> each.map(Object::toString).orElse("")).toList(),
          CsvRows.cells(line.substring(0, line.length() - 1)));
    }
  }

  @ParameterizedTest
  @CsvSource({
    "duration_2 < 0.4, 0.33, true",
    "duration_2 < 0.4, 0.4, false",
    "duration_2<=0.4, 0.4, true",
    "duration_2 >= 1e3, 1000.0, true",
    "duration_2 < 0.4, '', false",
    "duration_2 != 2, '', false",
    "outcome == finished, finished, true",
    "outcome == \"finished\", stopped, false",
    "outcome != stopped, finished, true",
    "var_n == 3, 3.0, true",
    "var_n > 2, 3, true"
  })
  void conditionHoldsForSomeCells(String text, String cell, boolean holds) throws PlanException {
    RowCondition condition = RowCondition.parse(text, ResultTable.of(plan()).columns());
    assertEquals(holds, condition.holds(cell));
  }

  @ParameterizedTest
  @CsvSource({
    "duration, '\"duration\" is no condition, must be like \"duration < 12\"'",
    "toque_share < 1, '\"toque_share < 1\": there is no column toque_share, did you mean"
        + " torque_share?'",
    "duration_2 < soon, '\"duration_2 < soon\" compares duration_2 with soon, must be a number'",
    "outcome < 3 s, '\"outcome < 3 s\" compares outcome with 3 s, must be a number'"
  })
  void conditionThatIsNoneIsRefused(String text, String message) throws PlanException {
    List<ResultColumn> columns = ResultTable.of(plan()).columns();
    assertEquals(
        message,
        assertThrows(IllegalArgumentException.class, () -> RowCondition.parse(text, columns))
            .getMessage());
    assertFalse(columns.isEmpty());
  }
}
