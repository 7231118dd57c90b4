package org.pendant.desktop.sweep;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.sweep.table.CellType;
import org.pendant.sweep.table.ResultColumn;

/** Row of a run: what the window keeps of a row of results. Immutable. */
final class RunRow {
  /** Long texts, which only the file has. */
  static final Set<String> LEFT_OUT = Set.of("lines", "outputs");

  private final double[] numbers;
  private final String[] texts;

  private RunRow(double[] numbers, String[] texts) {
    this.numbers = numbers;
    this.texts = texts;
  }

  /** What a result has in each column. */
  static RunRow of(List<ResultColumn> columns, List<Optional<Object>> row) {
    double[] numbers = new double[columns.size()];
    String[] texts = new String[columns.size()];
    for (int i = 0; i < numbers.length; i++) {
      Object cell = row.get(i).orElse("");
      boolean text = columns.get(i).type() == CellType.TEXT;
      numbers[i] = !text && cell instanceof Number number ? number.doubleValue() : Double.NaN;
      texts[i] = text ? kept(columns.get(i), cell.toString()) : "";
    }
    return new RunRow(numbers, texts);
  }

  /** The cells of a row of the file. */
  static RunRow read(List<ResultColumn> columns, List<String> cells) {
    List<Optional<Object>> row = new ArrayList<>();
    for (int i = 0; i < columns.size(); i++) {
      String cell = cells.get(i);
      row.add(
          columns.get(i).type() == CellType.TEXT
              ? Optional.of(cell)
              : cell.isEmpty() ? Optional.empty() : Optional.of(Double.valueOf(cell)));
    }
    return of(columns, row);
  }

  private static String kept(ResultColumn column, String text) {
    // outcomes and reasons are the same again and again
    return LEFT_OUT.contains(column.name()) ? "" : text.length() < 200 ? text.intern() : text;
  }

  /** Its number. */
  long run() {
    return (long) numbers[0];
  }

  /** The number in a column; not a number (NaN) where there is none. */
  double number(int column) {
    return numbers[column];
  }

  /** The text in a column of texts. */
  String text(int column) {
    return texts[column];
  }

  /** As the file has it. */
  String cell(int column) {
    return texts[column].isEmpty() && !Double.isNaN(numbers[column])
        ? Double.toString(numbers[column])
        : texts[column];
  }
}
