package org.pendant.sweep;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.pendant.sweep.engine.Engine;
import org.pendant.sweep.engine.EngineException;
import org.pendant.sweep.engine.ResultSink;
import org.pendant.sweep.folder.ResultReader;
import org.pendant.sweep.folder.SweepFolder;
import org.pendant.sweep.folder.SweepFolderException;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.search.SweepSearch;
import org.pendant.sweep.table.CsvRows;

/** Search loop: runs one generation of a search after another, each on all workers. */
final class SearchLoop {
  private final SweepSearch search;
  private final SweepFolder folder;
  private final Engine engine;

  SearchLoop(SweepPlan plan, SweepFolder folder, Engine engine) {
    search = new SweepSearch(plan, folder.table());
    this.folder = folder;
    this.engine = engine;
  }

  /**
   * Runs what is missing.
   *
   * @param out with the rows that there are
   * @return how many rows there are then
   */
  long run(Path out, ResultSink sink, BooleanSupplier stopped)
      throws IOException, EngineException, SweepFolderException {
    takeRows(out);
    long done = folder.next();
    List<SweepVariant> next = search.next();
    while (!next.isEmpty() && !stopped.getAsBoolean()) {
      List<SweepVariant> generation = next;
      long first = done;
      done =
          engine.run(
              number -> generation.get((int) (number - first)),
              first,
              first + generation.size(),
              result -> {
                sink.take(result);
                String row = CsvRows.row(folder.table().row(result));
                search.take(CsvRows.cells(row.substring(0, row.length() - 1)));
              },
              stopped);
      next = search.next();
    }
    return done;
  }

  private void takeRows(Path out) throws IOException, SweepFolderException {
    if (folder.next() == 0) {
      return;
    }
    try (ResultReader reader = new ResultReader(out.resolve(SweepFolder.RESULTS))) {
      Optional<List<String>> row = reader.next();
      while (row.isPresent()) {
        search.take(row.get());
        row = reader.next();
      }
    }
  }
}
