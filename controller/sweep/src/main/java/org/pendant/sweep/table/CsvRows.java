package org.pendant.sweep.table;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Rows as CSV (RFC 4180) with lines that end in a line feed: a header with the names of the
 * columns, then a row for each variant, in the order of their numbers. Numbers read back as the
 * same to the last bit; what there is no number for is empty.
 */
public final class CsvRows {
  private CsvRows() {}

  /** The header. */
  public static String header(List<ResultColumn> columns) {
    return columns.stream()
        .map(each -> quoted(each.name()))
        .collect(Collectors.joining(",", "", "\n"));
  }

  /** One row. */
  public static String row(List<Optional<Object>> cells) {
    StringBuilder row = new StringBuilder(cells.size() * 12);
    for (int i = 0; i < cells.size(); i++) {
      if (i > 0) {
        row.append(',');
      }
      cells.get(i).ifPresent(cell -> row.append(quoted(cell.toString())));
    }
    return row.append('\n').toString();
  }

  /** Writes a text as UTF-8. */
  public static void write(OutputStream out, String text) throws IOException {
    out.write(text.getBytes(StandardCharsets.UTF_8));
  }

  private static String quoted(String text) {
    boolean plain = true;
    for (int i = 0; i < text.length() && plain; i++) {
      char each = text.charAt(i);
      plain = each != ',' && each != '"' && each != '\n' && each != '\r';
    }
    return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  /**
   * The cells of a row.
   *
   * @param line without its line feed; a cell with one in it makes a row of several lines, which
   *     the caller has put together
   */
  public static List<String> cells(String line) {
    List<String> cells = new ArrayList<>();
    StringBuilder cell = new StringBuilder();
    boolean inQuotes = false;
    for (int i = 0; i < line.length(); i++) {
      char each = line.charAt(i);
      if (inQuotes && each == '"' && i + 1 < line.length() && line.charAt(i + 1) == '"') {
        cell.append('"');
        i++;
      } else if (each == '"') {
        inQuotes = !inQuotes;
      } else if (each == ',' && !inQuotes) {
        cells.add(cell.toString());
        cell.setLength(0);
      } else {
        cell.append(each);
      }
    }
    cells.add(cell.toString());
    return cells;
  }
}
