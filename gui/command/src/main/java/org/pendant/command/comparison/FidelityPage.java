package org.pendant.command.comparison;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.recording.compare.Difference;
import org.pendant.recording.compare.SampledQuantity;

/**
 * Fidelity page: what came out of comparing several recordings with Pendant, as Markdown with
 * charts in files of their own.
 */
public final class FidelityPage {
  private static final String INTRODUCTION =
      """
      # Fidelity

      How far Pendant agrees with recordings of real arms. This page is made by

      ```sh
      ./pendant compare --collection docs/recordings/recordings.txt --markdown docs/fidelity.md --force
      ```

      from [recordings/](recordings/README.md), which says where they come from, under which licence, and how to add one.
      Nothing on it is written by hand: where Pendant is off, the tables say so.

      The arm begins where the recording begins, with its payload, and runs the program that the robot ran, in virtual
      time. Both are laid upon one another by the least squares of the joint speeds, and compared at the times of the
      recording's samples.

      - `duration` is the time from rest to rest, `half-duration` that between the crossings of half the top speed, `start`
        and `stop` what lies before and after. When an arm leaves rest is known between two samples only; inside of these
        Pendant is not off.
      - `path-mean` and `path-max` are distances of the recording's TCP from Pendant's path, whatever the time; both are worked
        out from the joints with the same TCP.
      - `lag` is target less actual position over target speed while a joint moves; `speed-error` and `current-error` are the
        rms of actual less target reading meanwhile. These say how ideal the drives are: what counts is that both are alike.
      - Below them, each quantity: the range of the recording, and the rms of Pendant less recording for each joint or axis.
        Noise differs from run to run, so that of noisy readings is never 0.
      """;

  private static final String TABLES =
      """

      ## Other tables

      `pendant compare` reads tables of text with any of these headings, with commas, semicolons, tabs or spaces:

      - RTDE fields as UR's `record.py` and `pendant record` write them: `timestamp`, `actual_q_0` to `actual_q_5`, ... `time_s`
        may stand for `timestamp`;
      - Pendant's own tables (`run --record out.csv`), and `.rec` files;
      - `/joint_states` of a ROS bag: `ros2 topic echo --csv` (no headings), `rostopic echo -p` (`field.position0`),
        `rosbag_to_csv` and bagpy (`position` with a list, or `position_0`), PlotJuggler (`.../elbow_joint/position`). Joints
        are told by their names, in any order, and may have a prefix. Effort is taken for the current in A, as the drivers of these
        arms publish it.

      Columns that are not known are left alone. Quantities that lack a joint are left out, with a note. A table of positions
      alone will do: speeds are worked out then.
      """;

  /** What was compared under a heading. */
  public record Entry(String heading, String line, ComparedRun run) {}

  private final String chartFolder;
  private final StringBuilder page = new StringBuilder(INTRODUCTION);
  private final Map<String, String> charts = new LinkedHashMap<>();

  private FidelityPage(String chartFolder) {
    this.chartFolder = chartFolder;
  }

  /**
   * A page and its charts.
   *
   * @param text in Markdown
   * @param charts SVG by file name
   */
  public record Files(String text, Map<String, String> charts) {
    /** Copies the map. */
    public Files {
      charts = Map.copyOf(charts);
    }
  }

  /**
   * The page about some recordings.
   *
   * @param chartFolder the folder of the charts, as links of the page name it
   */
  public static Files of(List<Entry> entries, String chartFolder) {
    FidelityPage page = new FidelityPage(chartFolder);
    entries.forEach(page::add);
    page.page.append(TABLES);
    return new Files(page.page.toString(), page.charts);
  }

  private void add(Entry entry) {
    ComparedRun run = entry.run();
    page.append("\n## ").append(entry.heading()).append("\n\n```sh\npendant compare ");
    page.append(entry.line()).append("\n```\n\n").append(run.comparison().recorded().rows());
    page.append(" samples; payload ").append(run.payload()).append(".\n\n");
    run.comparison().notes().forEach(note -> page.append("- ").append(note).append("\n"));
    if (!run.limits().isEmpty()) {
      page.append("\n| aim | at most | Pendant is off by | |\n| --- | ---: | ---: | --- |\n");
      for (ComparedRun.Limit each : run.limits()) {
        row(
            List.of(
                each.name(),
                Difference.text(each.most()),
                Difference.text(each.size()),
                each.kept() ? "met" : "**missed**"));
      }
    }
    page.append("\n| figure | unit | recorded | Pendant | error |\n");
    page.append("| --- | --- | ---: | ---: | ---: |\n");
    for (Difference each : run.comparison().differences()) {
      if (each instanceof Difference.Figure) {
        row(ComparisonPage.cells(each));
      }
    }
    page.append("\n| quantity | unit | recorded | rms of Pendant less recording | largest | |\n");
    page.append("| --- | --- | --- | --- | ---: | --- |\n");
    for (StateQuantity each : run.charts()) {
      quantity(run, each);
    }
  }

  private void quantity(ComparedRun run, StateQuantity quantity) {
    String name = SampledQuantity.name(quantity);
    List<Difference.Residual> residuals = new ArrayList<>();
    for (Difference each : run.comparison().differences()) {
      if (each instanceof Difference.Residual residual && belongs(residual.name(), name)) {
        residuals.add(residual);
      }
    }
    double least = residuals.stream().mapToDouble(Difference.Residual::least).min().orElseThrow();
    double most = residuals.stream().mapToDouble(Difference.Residual::most).max().orElseThrow();
    double largest = 0;
    List<String> rms = new ArrayList<>();
    for (Difference.Residual each : residuals) {
      rms.add(Difference.text(each.rms()));
      largest = Math.abs(each.largest()) > Math.abs(largest) ? each.largest() : largest;
    }
    String file = chartName(run.recording(), name);
    charts.put(file, ChartSvg.of(run.comparison(), quantity));
    row(
        List.of(
            name,
            residuals.getFirst().unit(),
            Difference.text(least) + " to " + Difference.text(most),
            String.join(", ", rms),
            Difference.text(largest),
            "[chart](" + chartFolder + "/" + file + ")"));
  }

  private static boolean belongs(String residual, String quantity) {
    return residual.startsWith(quantity)
        && residual.substring(quantity.length()).matches("(_(\\d|rotation))?");
  }

  private static String chartName(String recording, String quantity) {
    String file = recording.substring(recording.lastIndexOf('/') + 1);
    int point = file.lastIndexOf('.');
    return (point > 0 ? file.substring(0, point) : file) + "-" + quantity + ".svg";
  }

  private void row(List<String> cells) {
    page.append("| ").append(String.join(" | ", cells)).append(" |\n");
  }
}
