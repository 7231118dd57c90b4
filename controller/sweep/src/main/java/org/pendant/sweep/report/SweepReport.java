package org.pendant.sweep.report;

import static org.pendant.sweep.report.ReportTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.pendant.models.json.JsonValues;
import org.pendant.sweep.folder.KeptRuns;
import org.pendant.sweep.folder.ResultReader;
import org.pendant.sweep.folder.SweepFolder;
import org.pendant.sweep.folder.SweepFolderException;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.PlanReader;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.table.CellType;
import org.pendant.sweep.table.ResultColumn;
import org.pendant.sweep.table.ResultTable;

/** Sweep report: the results of a sweep as one page of HTML, which needs nothing else. */
public final class SweepReport {
  /** A page with more rows takes seconds to draw. */
  private static final int MAX_ROWS = 5000;

  /** What has no place in a plot. */
  private static final Set<String> LEFT_OUT = Set.of("lines", "outputs", "digest");

  private final Path folder;
  private final List<ResultColumn> columns = new ArrayList<>();
  private final List<Integer> places = new ArrayList<>();
  private final Set<String> parameters;
  private final ResultTable table;
  private final Map<String, Long> outcomes = new TreeMap<>();
  private final List<Long> kept = new ArrayList<>();
  private final StringBuilder rows = new StringBuilder();
  private final SweepPlan plan;
  private long all;

  private SweepReport(Path folder, SweepPlan plan) {
    this.folder = folder;
    this.plan = plan;
    table = ResultTable.of(plan);
    parameters =
        table.parameterColumns().stream().map(ResultColumn::name).collect(Collectors.toSet());
    for (int i = 0; i < table.columns().size(); i++) {
      if (!LEFT_OUT.contains(table.columns().get(i).name())) {
        columns.add(table.columns().get(i));
        places.add(i);
      }
    }
  }

  /**
   * The page about a folder of results.
   *
   * @throws SweepFolderException if it is none, or its table is not that of its plan
   */
  public static String of(Path folder) throws IOException, SweepFolderException {
    Path planFile = folder.resolve(SweepFolder.PLAN);
    if (!Files.isRegularFile(planFile)) {
      throw new SweepFolderException(text("noSweepFolder", folder));
    }
    try {
      SweepPlan plan =
          PlanReader.read(planFile.toString(), Files.readString(planFile, StandardCharsets.UTF_8));
      SweepReport report = new SweepReport(folder, plan);
      report.read();
      return report.page();
    } catch (PlanException e) {
      throw new SweepFolderException(e.getMessage());
    }
  }

  private void read() throws IOException, SweepFolderException {
    Path results = folder.resolve(SweepFolder.RESULTS);
    try (ResultReader reader = new ResultReader(results)) {
      if (!reader.columns().equals(table.columns().stream().map(ResultColumn::name).toList())) {
        throw new SweepFolderException(text("otherColumns", results));
      }
      int outcome = reader.column("outcome").orElseThrow();
      Optional<List<String>> row = reader.next();
      while (row.isPresent()) {
        outcomes.merge(row.get().get(outcome), 1L, Long::sum);
        row = reader.next();
      }
      all = reader.rows();
    }
    try (ResultReader reader = new ResultReader(results)) {
      Optional<List<String>> row = reader.next();
      while (row.isPresent()) {
        long number = reader.rows() - 1;
        if (number % every() == 0) {
          add(row.get());
          if (Files.exists(KeptRuns.file(folder, number))) {
            kept.add(number);
          }
        }
        row = reader.next();
      }
    }
  }

  /** Of so many rows the page has one. */
  private long every() {
    return Math.max(1, Math.ceilDiv(all, MAX_ROWS));
  }

  private void add(List<String> cells) {
    rows.append(rows.isEmpty() ? "\n[" : ",\n[");
    for (int i = 0; i < places.size(); i++) {
      String cell = cells.get(places.get(i));
      rows.append(i == 0 ? "" : ",");
      if (columns.get(i).type() == CellType.TEXT) {
        rows.append(JsonValues.text(cell));
      } else {
        rows.append(cell.isEmpty() ? "null" : cell);
      }
    }
    rows.append(']');
  }

  private String page() throws IOException {
    String title = "Sweep of " + plan.program();
    String counts =
        outcomes.entrySet().stream()
            .map(each -> each.getValue() + " " + each.getKey())
            .collect(Collectors.joining(", "));
    String summary =
        all
            + " runs: "
            + counts
            + "."
            + (every() > 1 ? " The plots show one of every " + every() + " runs." : "");
    return resource("report.html")
        .replace("@style@", resource("report.css"))
        .replace("@script@", resource("report.js"))
        .replace("@title@", escaped(title))
        .replace("@summary@", escaped(summary))
        .replace("@data@", data());
  }

  private String data() {
    String described =
        columns.stream()
            .map(
                each ->
                    "{\"name\":"
                        + JsonValues.text(each.name())
                        + ",\"unit\":"
                        + JsonValues.text(each.unit())
                        + ",\"description\":"
                        + JsonValues.text(each.description())
                        + ",\"number\":"
                        + (each.type() != CellType.TEXT)
                        + ",\"parameter\":"
                        + parameters.contains(each.name())
                        + "}")
            .collect(Collectors.joining(",\n"));
    String json =
        "{\"folder\":"
            + JsonValues.text(folder.toString())
            + ",\"kept\":"
            + kept
            + ",\"columns\":[\n"
            + described
            + "],\"rows\":["
            + rows
            + "]}";
    // nothing in it may end the element that it stands in
    return json.replace("<", "\\u003c");
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }

  private static String resource(String name) throws IOException {
    try (InputStream in = SweepReport.class.getResourceAsStream(name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
