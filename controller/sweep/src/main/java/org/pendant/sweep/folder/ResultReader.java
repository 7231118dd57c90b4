package org.pendant.sweep.folder;

import static org.pendant.sweep.folder.FolderTexts.text;

import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.sweep.table.CsvRows;

/**
 * Reader of a table of results, one row after another. A last row without its end, which a process
 * that was killed leaves, is not one.
 */
public final class ResultReader implements Closeable {
  private static final int MAX_ROW = 8 << 20;

  private final Path file;
  private final BufferedReader in;
  private final List<String> columns;
  private long bytes;
  private long rows;

  /**
   * Opens a table.
   *
   * @throws SweepFolderException if it has no header
   */
  public ResultReader(Path file) throws IOException, SweepFolderException {
    this.file = file;
    in = Files.newBufferedReader(file, StandardCharsets.UTF_8);
    try {
      columns =
          line()
              .map(CsvRows::cells)
              .orElseThrow(() -> new SweepFolderException(text("noHeader", file)));
    } catch (IOException | SweepFolderException e) {
      in.close();
      throw e;
    }
  }

  /** The names of the columns. */
  public List<String> columns() {
    return columns;
  }

  /** The place of a column; empty for one that is not there. */
  public Optional<Integer> column(String name) {
    int place = columns.indexOf(name);
    return place < 0 ? Optional.empty() : Optional.of(place);
  }

  /**
   * The cells of the next row; empty behind the last.
   *
   * @throws SweepFolderException if it is none of this table
   */
  public Optional<List<String>> next() throws IOException, SweepFolderException {
    Optional<String> line = line();
    if (line.isEmpty()) {
      return Optional.empty();
    }
    List<String> cells = CsvRows.cells(line.get());
    if (cells.size() != columns.size() || !cells.getFirst().equals(Long.toString(rows))) {
      throw new SweepFolderException(text("wrongRow", file, rows, rows));
    }
    rows++;
    return Optional.of(cells);
  }

  /** How many rows have been read. */
  public long rows() {
    return rows;
  }

  /** How many bytes of the file that is, the header included. */
  public long bytes() {
    return bytes;
  }

  /** A row without its line feed, those in quotes included. */
  private Optional<String> line() throws IOException, SweepFolderException {
    StringBuilder line = new StringBuilder();
    boolean inQuotes = false;
    for (int each = in.read(); each >= 0; each = in.read()) {
      if (each == '\n' && !inQuotes) {
        String text = line.toString();
        bytes += text.getBytes(StandardCharsets.UTF_8).length + 1;
        return Optional.of(text);
      }
      inQuotes ^= each == '"';
      line.append((char) each);
      if (line.length() > MAX_ROW) {
        throw new SweepFolderException(text("endlessRow", file, rows));
      }
    }
    return Optional.empty();
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
