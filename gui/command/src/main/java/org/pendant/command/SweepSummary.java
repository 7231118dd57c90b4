package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.pendant.sweep.run.RunOutcome;
import org.pendant.sweep.table.ResultColumn;
import org.pendant.sweep.table.ResultTable;
import org.pendant.sweep.table.RowCondition;

/** Sweep summary: what came of all runs of a sweep, row by row. Mutable. */
final class SweepSummary {
  private static final int DIGITS = 4;
  private static final int MAX_SHOWN = 5;
  private static final String OUTCOME = "outcome";
  private static final List<String> MEASURES =
      List.of(
          "duration",
          "torque_share",
          "speed_share",
          "tool_speed",
          "joint_limit",
          "plane",
          "singularity",
          "force",
          "energy");

  private final List<String> columns;
  private final List<RowCondition> conditions;
  private final Map<String, Long> outcomes = new TreeMap<>();
  private final List<Range> ranges = new ArrayList<>();
  private final long[] broken;
  private final List<List<String>> examples = new ArrayList<>();

  /** Least and most of a column, and the runs that they are of. */
  private static final class Range {
    private final int column;
    private double least = Double.POSITIVE_INFINITY;
    private double most = Double.NEGATIVE_INFINITY;
    private String leastRun = "";
    private String mostRun = "";

    private Range(int column) {
      this.column = column;
    }

    private void take(List<String> cells) {
      double value = Arguments.parsed(cells.get(column)).orElse(Double.NaN);
      if (value < least) {
        least = value;
        leastRun = cells.getFirst();
      }
      if (value > most) {
        most = value;
        mostRun = cells.getFirst();
      }
    }
  }

  SweepSummary(ResultTable table, List<RowCondition> conditions) {
    columns = table.columns().stream().map(ResultColumn::name).toList();
    this.conditions = conditions;
    broken = new long[conditions.size()];
    conditions.forEach(_ -> examples.add(new ArrayList<>()));
    for (String each : MEASURES) {
      ranges.add(new Range(columns.indexOf(each)));
    }
  }

  /** Takes a row, cell by cell as tables write it. */
  void take(List<String> cells) {
    outcomes.merge(cells.get(columns.indexOf(OUTCOME)), 1L, Long::sum);
    ranges.forEach(each -> each.take(cells));
    for (int i = 0; i < conditions.size(); i++) {
      RowCondition condition = conditions.get(i);
      String cell = cells.get(columns.indexOf(condition.column()));
      if (!condition.holds(cell)) {
        broken[i]++;
        if (examples.get(i).size() < MAX_SHOWN) {
          boolean outcome = condition.column().equals(OUTCOME);
          examples.get(i).add(text("runOf", cells.getFirst(), outcome ? shown(cell) : cell));
        }
      }
    }
  }

  /** Whether all conditions hold for all rows. */
  boolean allHold() {
    for (long each : broken) {
      if (each > 0) {
        return false;
      }
    }
    return true;
  }

  /** For people. */
  List<String> lines() {
    List<String> lines = new ArrayList<>();
    Table counts = new Table().left(text("outcomeHead")).right(text("runsHead"));
    outcomes.forEach((outcome, count) -> counts.row(shown(outcome), Long.toString(count)));
    lines.addAll(counts.aligned());
    Table measures =
        new Table()
            .left(text("measureHead"))
            .right(text("leastHead"))
            .right(text("runHead"))
            .right(text("mostHead"))
            .right(text("runHead"));
    for (Range each : ranges) {
      if (each.least <= each.most) {
        measures.row(
            columns.get(each.column),
            Decimal.text(each.least, DIGITS),
            each.leastRun,
            Decimal.text(each.most, DIGITS),
            each.mostRun);
      }
    }
    lines.add("");
    lines.addAll(measures.aligned());
    return lines;
  }

  /** An outcome, which tables write as a word. */
  private static String shown(String word) {
    return RunOutcome.of(word).map(each -> text(key(each))).orElse(word);
  }

  private static String key(RunOutcome outcome) {
    return switch (outcome) {
      case FINISHED -> "outcomeFinished";
      case HALTED -> "outcomeHalted";
      case FAILED -> "outcomeFailed";
      case STOPPED -> "outcomeStopped";
      case NEVER_ENDED -> "outcomeNeverEnded";
      case DOES_NOT_COMPILE -> "outcomeDoesNotCompile";
      case REFUSED -> "outcomeRefused";
      case INTERNAL_ERROR -> "outcomeInternalError";
    };
  }

  /** What does not hold, a line for each condition. */
  List<String> broken() {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < conditions.size(); i++) {
      if (broken[i] > 0) {
        lines.add(
            text(
                broken[i] == 1 ? "doesNotHoldForRun" : "doesNotHoldForRuns",
                conditions.get(i).text(),
                broken[i],
                String.join(", ", examples.get(i)) + (broken[i] > MAX_SHOWN ? ", ..." : "")));
      }
    }
    return lines;
  }
}
