package org.pendant.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.project.program.file.TreeFile;
import org.pendant.recording.lines.LineStatistics;
import org.pendant.recording.lines.Margin;
import org.pendant.recording.lines.RunProfile;
import org.pendant.recording.lines.Worst;

/** Line table: the lines of a program with what each took of a run, as text. */
final class LineTable {
  /** What the table for programs begins with. */
  private static final List<String> COLUMNS =
      List.of(
          "line",
          "executions",
          "time_s",
          "longest_s",
          "share",
          "path_m",
          "tool_speed_m_s",
          "joint_speed",
          "joint_speed_of",
          "torque",
          "torque_of",
          "joint_limit_rad",
          "joint_limit_of",
          "plane_m",
          "plane",
          "node",
          "text");

  private final List<String> texts;
  private final Optional<TreeFile> tree;
  private final String name;

  LineTable(RunnableFile program) {
    name = program.file();
    texts =
        program.source().map(Source::text).map(ByteText::decoded).stream()
            .flatMap(String::lines)
            .map(String::strip)
            .toList();
    tree = program.tree();
  }

  private String text(int line) {
    return line <= texts.size() ? texts.get(line - 1) : "";
  }

  private String node(int line) {
    return tree.flatMap(each -> each.nodeAt(line)).orElse("");
  }

  // --- for programs

  /** All numbers with all their digits, with commas between; a field without a value is empty. */
  String csv(RunProfile profile) {
    List<String> rows = new ArrayList<>();
    rows.add(String.join(",", COLUMNS));
    profile.lines().forEach(line -> rows.add(row(profile, line)));
    return String.join("\n", rows) + "\n";
  }

  private String row(RunProfile profile, LineStatistics line) {
    List<String> fields =
        new ArrayList<>(
            List.of(
                String.valueOf(line.line()),
                String.valueOf(line.executions()),
                // whole frames, so that sums of times show no rounding
                Decimal.text(line.timeS(), 3),
                Decimal.text(line.longestS(), 3),
                String.valueOf(profile.share(line)),
                String.valueOf(line.pathM()),
                String.valueOf(line.toolSpeedMPerS())));
    for (Margin each :
        List.of(Margin.JOINT_SPEED, Margin.TORQUE, Margin.JOINT_LIMIT, Margin.PLANE)) {
      Optional<Worst> worst = line.worst(each);
      fields.add(worst.map(Worst::value).map(String::valueOf).orElse(""));
      fields.add(worst.map(Worst::part).map(LineTable::quoted).orElse(""));
    }
    fields.add(quoted(node(line.line())));
    fields.add(quoted(text(line.line())));
    return String.join(",", fields);
  }

  private static String quoted(String text) {
    boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"');
    return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  // --- for people

  /** Rounded, in columns. */
  String text(RunProfile profile) {
    Table table =
        new Table()
            .right("line")
            .right("time")
            .right("share")
            .right("times")
            .right("longest")
            .right("path")
            .right("tool")
            .left("joint speed")
            .left("torque")
            .left("joint limit")
            .left("plane")
            .left(tree.isPresent() ? "node" : "text");
    for (LineStatistics line : profile.lines()) {
      table.row(
          String.valueOf(line.line()),
          number("%.3f s", line.timeS()),
          number("%.0f %%", 100 * profile.share(line)),
          String.valueOf(line.executions()),
          number("%.3f s", line.longestS()),
          line.moved() ? number("%.1f mm", 1000 * line.pathM()) : "",
          line.moved() ? number("%.0f mm/s", 1000 * line.toolSpeedMPerS()) : "",
          worst(line, Margin.JOINT_SPEED, "%.0f %% ", 100),
          worst(line, Margin.TORQUE, "%.0f %% ", 100),
          worst(line, Margin.JOINT_LIMIT, "%.0f° ", Math.toDegrees(1)),
          worst(line, Margin.PLANE, "%.1f mm ", 1000),
          tree.isPresent() ? node(line.line()) : text(line.line()));
    }
    return table.aligned().stream()
        .collect(Collectors.joining("\n", name + number(": %.3f s\n", profile.timeS()), "\n"));
  }

  private static String worst(LineStatistics line, Margin margin, String form, double factor) {
    return line.worst(margin)
        .map(each -> number(form, factor * each.value()) + each.part())
        .orElse("");
  }

  private static String number(String form, double value) {
    return String.format(Locale.ROOT, form, value);
  }
}
