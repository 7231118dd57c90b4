package org.pendant.command;

import java.util.ArrayList;
import java.util.List;
import org.pendant.text.TerminalColumns;

/** Table: rows of text under headings, as aligned columns or as Markdown. */
final class Table {
  private final List<Column> columns = new ArrayList<>();
  private final List<List<String>> rows = new ArrayList<>();

  private record Column(String heading, boolean alignedRight) {}

  /** Adds a column of words. */
  Table left(String heading) {
    columns.add(new Column(heading, false));
    return this;
  }

  /** Adds a column of numbers. */
  Table right(String heading) {
    columns.add(new Column(heading, true));
    return this;
  }

  /** Adds a row; every column needs its cell. */
  void row(String... cells) {
    if (cells.length != columns.size()) {
      throw new IllegalArgumentException(
          "row has " + cells.length + " cells, must have " + columns.size());
    }
    rows.add(List.of(cells));
  }

  /** The headings and rows, each column as wide on a terminal as its widest cell. */
  List<String> aligned() {
    List<String> lines = new ArrayList<>();
    lines.add(line(columns.stream().map(Column::heading).toList()));
    rows.forEach(row -> lines.add(line(row)));
    return lines;
  }

  private String line(List<String> cells) {
    StringBuilder line = new StringBuilder();
    for (int i = 0; i < cells.size(); i++) {
      String cell = cells.get(i);
      String padding = " ".repeat(width(i) - TerminalColumns.of(cell));
      line.append(i == 0 ? "" : "  ")
          .append(columns.get(i).alignedRight() ? padding + cell : cell + padding);
    }
    return line.toString().stripTrailing();
  }

  private int width(int column) {
    int width = TerminalColumns.of(columns.get(column).heading());
    for (List<String> row : rows) {
      width = Math.max(width, TerminalColumns.of(row.get(column)));
    }
    return width;
  }

  /** The same in Markdown. */
  List<String> markdown() {
    List<String> lines = new ArrayList<>();
    lines.add(markdownLine(columns.stream().map(Column::heading).toList()));
    lines.add(markdownLine(columns.stream().map(c -> c.alignedRight() ? "---:" : "---").toList()));
    rows.forEach(row -> lines.add(markdownLine(row)));
    return lines;
  }

  private static String markdownLine(List<String> cells) {
    return "| " + String.join(" | ", cells) + " |";
  }
}
