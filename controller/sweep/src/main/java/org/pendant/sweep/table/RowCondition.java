package org.pendant.sweep.table;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.language.check.Nearest;

/**
 * Row condition: what must hold for a row of results, such as {@code duration < 12} or {@code
 * outcome == finished}.
 *
 * @param text as it was written
 * @param column that is looked at
 * @param relation one of {@code < <= > >= == !=}
 * @param bound what the cell is compared with
 */
public record RowCondition(String text, String column, String relation, String bound) {
  private static final Pattern FORM =
      Pattern.compile("\\s*(.+?)\\s*(<=|>=|==|!=|<|>)\\s*\"?([^\"]*?)\"?\\s*");

  /**
   * Reads a condition.
   *
   * @param columns that there are
   * @throws IllegalArgumentException says what would be right
   */
  public static RowCondition parse(String text, List<ResultColumn> columns) {
    Matcher parts = FORM.matcher(text);
    if (!parts.matches()) {
      throw new IllegalArgumentException(TableTexts.text("noCondition", text));
    }
    String name = parts.group(1);
    Optional<ResultColumn> column =
        columns.stream().filter(each -> each.name().equals(name)).findFirst();
    if (column.isEmpty()) {
      Supplier<List<String>> names = () -> columns.stream().map(ResultColumn::name).toList();
      throw new IllegalArgumentException(
          new Nearest()
              .to(name, names::get)
              .map(near -> TableTexts.text("noColumnDidYouMean", text, name, near))
              .orElseGet(() -> TableTexts.text("noColumn", text, name)));
    }
    RowCondition condition = new RowCondition(text, name, parts.group(2), parts.group(3));
    boolean words =
        column.get().type() == CellType.TEXT
            && (condition.relation.equals("==") || condition.relation.equals("!="));
    if (!words && Double.isNaN(number(condition.bound))) {
      throw new IllegalArgumentException(TableTexts.text("noNumber", text, name, condition.bound));
    }
    return condition;
  }

  private static double number(String text) {
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  /**
   * By how much a cell misses it: 0 where it holds; a share of the bound for numbers, 1 for another
   * word, 10 where there is no number.
   */
  public double missedBy(String cell) {
    if (holds(cell)) {
      return 0;
    }
    double value = number(cell);
    double limit = number(bound);
    if (Double.isNaN(limit)) {
      return 1;
    }
    return Double.isNaN(value)
        ? 10
        : Math.max(1e-9, Math.min(10, Math.abs(value - limit) / (Math.abs(limit) + 1e-9)));
  }

  /**
   * Whether a cell keeps it. One that is empty, or no number where one is compared, does not.
   *
   * @param cell as tables write it
   */
  public boolean holds(String cell) {
    double value = number(cell);
    double limit = number(bound);
    if (Double.isNaN(limit)) {
      return relation.equals("==") == cell.equals(bound);
    }
    return switch (relation) {
      case "<" -> value < limit;
      case "<=" -> value <= limit;
      case ">" -> value > limit;
      case ">=" -> value >= limit;
      case "==" -> value == limit;
      default -> !Double.isNaN(value) && value != limit;
    };
  }
}
