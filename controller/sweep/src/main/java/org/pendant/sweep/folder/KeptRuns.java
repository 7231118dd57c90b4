package org.pendant.sweep.folder;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.language.check.Nearest;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.run.RunOutcome;
import org.pendant.sweep.run.RunRecorder;
import org.pendant.sweep.run.SweepJob;
import org.pendant.sweep.run.SweepResult;
import org.pendant.sweep.table.CellType;
import org.pendant.sweep.table.ResultColumn;
import org.pendant.sweep.table.ResultTable;

/**
 * Kept runs: which runs of a sweep people want to look at, and their recordings. A recording is
 * made by running the variant once more, which comes out the same; so any run of a table can be had
 * at any time.
 */
public final class KeptRuns {
  private static final String FOLDER = "kept";
  private static final String FAILED = "failed";
  private static final String WORST = "worst";
  private static final List<String> SHARES =
      List.of("torque_share", "speed_share", "tool_speed_share");
  private static final int MAX_KEPT = 10_000;

  private final List<Wish> wishes;

  /** Runs of one kind: failed, worst, or those with the largest numbers in a column. */
  private record Wish(String what, int count) {}

  /** A run with the number that it is ranked by. */
  private record Ranked(long run, double value) {}

  private KeptRuns(List<Wish> wishes) {
    this.wishes = List.copyOf(wishes);
  }

  /**
   * Reads a wish such as {@code worst=5,failed=20}.
   *
   * @throws IllegalArgumentException says what would be right
   */
  public static KeptRuns parse(String text, ResultTable table) {
    List<String> names = new ArrayList<>(List.of(FAILED, WORST));
    table.columns().stream()
        .filter(each -> each.type() != CellType.TEXT)
        .map(ResultColumn::name)
        .forEach(names::add);
    List<Wish> wishes = new ArrayList<>();
    for (String each : text.split(",", -1)) {
      int equals = each.lastIndexOf('=');
      String what = equals < 0 ? each.strip() : each.substring(0, equals).strip();
      int count = equals < 0 ? 0 : number(each.substring(equals + 1).strip());
      if (!names.contains(what)) {
        throw new IllegalArgumentException(
            new Nearest()
                .to(what, () -> names)
                .map(near -> FolderTexts.text("notToKeepDidYouMean", what, near))
                .orElseGet(() -> FolderTexts.text("notToKeep", what)));
      }
      if (count < 1) {
        throw new IllegalArgumentException(
            FolderTexts.text("wrongCount", each.strip(), what, MAX_KEPT));
      }
      wishes.add(new Wish(what, count));
    }
    return new KeptRuns(wishes);
  }

  private static int number(String text) {
    try {
      int number = Integer.parseInt(text);
      return number <= MAX_KEPT ? number : 0;
    } catch (NumberFormatException e) {
      return 0;
    }
  }

  /** The numbers of the runs of a table that are wanted. */
  public SortedSet<Long> choose(ResultReader rows) throws IOException, SweepFolderException {
    List<PriorityQueue<Ranked>> best = new ArrayList<>();
    for (Wish _ : wishes) {
      best.add(
          new PriorityQueue<>(
              Comparator.comparingDouble(Ranked::value).thenComparing(each -> -each.run())));
    }
    Optional<List<String>> row = rows.next();
    while (row.isPresent()) {
      for (int i = 0; i < wishes.size(); i++) {
        double value = rank(wishes.get(i).what(), row.get(), rows);
        if (!Double.isNaN(value)) {
          best.get(i).add(new Ranked(rows.rows() - 1, value));
          if (best.get(i).size() > wishes.get(i).count()) {
            best.get(i).poll();
          }
        }
      }
      row = rows.next();
    }
    SortedSet<Long> chosen = new TreeSet<>();
    best.forEach(each -> each.forEach(ranked -> chosen.add(ranked.run())));
    return chosen;
  }

  private static double rank(String what, List<String> cells, ResultReader rows) {
    boolean ended =
        RunOutcome.of(cells.get(rows.column("outcome").orElseThrow()))
            .filter(RunOutcome::ended)
            .isPresent();
    return switch (what) {
      case FAILED -> ended ? Double.NaN : 0;
      case WORST ->
          ended
              ? SHARES.stream()
                  .mapToDouble(each -> value(cells.get(rows.column(each).orElseThrow())))
                  .max()
                  .orElseThrow()
              : Double.NaN;
      default -> value(cells.get(rows.column(what).orElseThrow()));
    };
  }

  private static double value(String cell) {
    return cell.isEmpty() ? Double.NaN : Double.parseDouble(cell);
  }

  /** Where the recording of a run is, or would be. */
  public static Path file(Path folder, long run) {
    return folder.resolve(FOLDER).resolve(run + ".rec");
  }

  /** Removes all recordings of a folder. */
  static void clear(Path folder) throws IOException {
    Path kept = folder.resolve(FOLDER);
    if (!Files.isDirectory(kept)) {
      return;
    }
    try (Stream<Path> files = Files.list(kept)) {
      for (Path each : (Iterable<Path>) files::iterator) {
        if (each.getFileName().toString().matches("\\d+\\.rec")) {
          Files.delete(each);
        }
      }
    }
  }

  /**
   * Runs a variant once more and writes its recording, unless that is there.
   *
   * @param digest what the table has of the run
   * @throws SweepFolderException if the run came out otherwise, or ended before its first frame
   */
  public static Path record(Path folder, SweepJob job, SweepVariant variant, String digest)
      throws IOException, SweepFolderException {
    long run = variant.number();
    Path file = file(folder, run);
    if (Files.exists(file)) {
      return file;
    }
    SweepResult[] result = new SweepResult[1];
    boolean[] recorded = {false};
    AtomicFile.write(
        file,
        out -> {
          try (RunRecorder recorder = new RunRecorder(out)) {
            result[0] = job.run(variant, recorder);
            recorded[0] = recorder.recorded();
          }
        });
    String now = String.format("%016x", result[0].digest());
    if (!recorded[0] || !now.equals(digest)) {
      Files.deleteIfExists(file);
      throw new SweepFolderException(
          recorded[0]
              ? FolderTexts.text("otherDigest", run, now)
              : FolderTexts.text("endedAtOnce", run, result[0].reason()));
    }
    return file;
  }
}
