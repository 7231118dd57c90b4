package org.pendant.sweep.folder;

import static org.pendant.sweep.folder.FolderTexts.text;

import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.GrowingFile;
import org.pendant.sweep.folder.SweepFolderException.Earlier;
import org.pendant.sweep.run.SweepJob;
import org.pendant.sweep.table.CsvRows;
import org.pendant.sweep.table.ParquetTable;
import org.pendant.sweep.table.ResultTable;

/**
 * Folder with the results of one sweep: the plan, where its files are, and the table. The table
 * grows by whole rows in the order of the runs, so its rows are all that is needed to go on when
 * the process has ended early. One thread uses it.
 */
public final class SweepFolder implements Closeable {
  /** The table. */
  public static final String RESULTS = "results.csv";

  /** The same table in Parquet's format. */
  public static final String PARQUET = "results.parquet";

  /** The page about it. */
  public static final String REPORT = "report.html";

  /** Where the plan was, and what it was. */
  public static final String ORIGIN = "origin.txt";

  /** A copy of the plan. */
  public static final String PLAN = "plan.toml";

  private static final long FLUSH_NS = 1_000_000_000;
  private static final int FLUSH_ROWS = 1000;

  private final ResultTable table;
  private final GrowingFile rows;
  private final long next;
  private long flushedNs = System.nanoTime();
  private int unflushed;

  private SweepFolder(ResultTable table, GrowingFile rows, long next) {
    this.table = table;
    this.rows = rows;
    this.next = next;
  }

  /**
   * Begins a folder.
   *
   * @param folder is made where it is missing
   * @param plan the file that the job was read from
   * @throws SweepFolderException if there are results in it
   */
  public static SweepFolder create(Path folder, Path plan, SweepJob job)
      throws IOException, SweepFolderException {
    Path results = folder.resolve(RESULTS);
    if (begun(folder)) {
      throw new SweepFolderException(text("hasResults", folder), Earlier.ANY);
    }
    Files.createDirectories(folder);
    AtomicFile.write(folder.resolve(PLAN), job.planText().getBytes(StandardCharsets.UTF_8));
    AtomicFile.write(
        folder.resolve(ORIGIN),
        (job.identity() + "\n" + plan.toAbsolutePath() + "\n").getBytes(StandardCharsets.UTF_8));
    ResultTable table = ResultTable.of(job.plan());
    GrowingFile rows = GrowingFile.create(results);
    CsvRows.write(rows, CsvRows.header(table.columns()));
    rows.flush();
    return new SweepFolder(table, rows, 0);
  }

  /**
   * Goes on with a folder.
   *
   * @throws SweepFolderException if it is that of another plan, or was written by other files
   */
  public static SweepFolder resume(Path folder, SweepJob job)
      throws IOException, SweepFolderException {
    Path results = folder.resolve(RESULTS);
    if (!origin(folder).getFirst().equals(job.identity())) {
      throw new SweepFolderException(text("otherResults", folder), Earlier.OTHER);
    }
    ResultTable table = ResultTable.of(job.plan());
    long done;
    long bytes;
    try (ResultReader reader = new ResultReader(results)) {
      while (reader.next().isPresent()) {
        // counted
      }
      done = reader.rows();
      bytes = reader.bytes();
    }
    return new SweepFolder(table, GrowingFile.resume(results, bytes), done);
  }

  /** The plan's file that the results of a folder are of. */
  public static Path planOf(Path folder) throws IOException, SweepFolderException {
    return Path.of(origin(folder).get(1));
  }

  private static List<String> origin(Path folder) throws IOException, SweepFolderException {
    Path origin = folder.resolve(ORIGIN);
    if (!Files.isRegularFile(origin)) {
      throw new SweepFolderException(text("noSweepFolder", folder, ORIGIN));
    }
    List<String> lines = Files.readAllLines(origin, StandardCharsets.UTF_8);
    if (lines.size() < 2) {
      throw new SweepFolderException(text("lineCount", origin, lines.size()));
    }
    return lines;
  }

  /** Whether there are results in a folder. */
  public static boolean begun(Path folder) {
    return Files.exists(folder.resolve(RESULTS));
  }

  /** Removes what a sweep has left in a folder, if there is anything. */
  public static void clear(Path folder) throws IOException {
    Files.deleteIfExists(folder.resolve(RESULTS));
    Files.deleteIfExists(folder.resolve(PARQUET));
    Files.deleteIfExists(folder.resolve(REPORT));
    KeptRuns.clear(folder);
  }

  /** Writes the table once more, in Parquet's format, as far as it has come. */
  public static void writeParquet(Path folder, ResultTable table)
      throws IOException, SweepFolderException {
    try (ResultReader rows = new ResultReader(folder.resolve(RESULTS))) {
      AtomicFile.write(
          folder.resolve(PARQUET),
          out -> {
            ParquetTable parquet = new ParquetTable(out, table.columns());
            try {
              Optional<List<String>> row = rows.next();
              while (row.isPresent()) {
                parquet.add(row.get());
                row = rows.next();
              }
            } catch (SweepFolderException e) {
              throw new IOException(e.getMessage(), e);
            }
            parquet.end();
          });
    }
  }

  /** How many rows there were when it was opened. */
  public long next() {
    return next;
  }

  /** The columns. */
  public ResultTable table() {
    return table;
  }

  /** Adds a row; it is in the file a second later at the latest. */
  public void add(List<Optional<Object>> row) throws IOException {
    CsvRows.write(rows, CsvRows.row(row));
    unflushed++;
    if (unflushed >= FLUSH_ROWS || System.nanoTime() - flushedNs > FLUSH_NS) {
      rows.flush();
      unflushed = 0;
      flushedNs = System.nanoTime();
    }
  }

  @Override
  public void close() throws IOException {
    rows.close();
  }
}
