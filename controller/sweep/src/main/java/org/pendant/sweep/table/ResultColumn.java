package org.pendant.sweep.table;

import java.util.Optional;
import java.util.function.Function;
import org.pendant.sweep.run.SweepResult;

/**
 * Result column: one column of a table of results.
 *
 * @param name its own in the table
 * @param type of its cells
 * @param unit of its numbers; empty for none
 * @param description for people
 * @param getter what a result has in it: an object of the type, empty where there is none
 */
public record ResultColumn(
    String name,
    CellType type,
    String unit,
    String description,
    Function<SweepResult, Optional<Object>> getter) {

  /** A column of numbers; those that are not finite are left out. */
  static ResultColumn number(
      String name, String unit, String description, Function<SweepResult, Double> getter) {
    return new ResultColumn(
        name,
        CellType.NUMBER,
        unit,
        description,
        result -> Optional.<Object>of(getter.apply(result)).filter(ResultColumn::finite));
  }

  private static boolean finite(Object number) {
    return number instanceof Double value && Double.isFinite(value);
  }

  /** A column of texts. */
  static ResultColumn text(String name, String description, Function<SweepResult, String> getter) {
    return new ResultColumn(
        name, CellType.TEXT, "", description, result -> Optional.of(getter.apply(result)));
  }

  /** A column of whole numbers. */
  static ResultColumn whole(String name, String description, Function<SweepResult, Long> getter) {
    return new ResultColumn(
        name, CellType.WHOLE, "", description, result -> Optional.of(getter.apply(result)));
  }
}
