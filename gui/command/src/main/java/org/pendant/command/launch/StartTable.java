package org.pendant.command.launch;

import java.util.ArrayList;
import java.util.List;

/** Start table: the options of each {@link StartKind} as the launchers in shell read them. */
public final class StartTable {
  private StartTable() {}

  /** Prints it, for {@code .build/options.sh}. */
  public static void main(String[] words) {
    lines().forEach(System.out::println);
  }

  static List<String> lines() {
    List<String> lines = new ArrayList<>();
    lines.add(
        "# Options of the JVM for each kind of start. StartKind in gui/command declares them and");
    lines.add("# says why; StartTable writes this file, and a test compares.");
    lines.add("# shellcheck shell=sh disable=SC2034 # variables that others read");
    lines.add("flags='" + String.join(" ", StartKind.COMMON) + "'");
    lines.add("optimizing='" + StartKind.Options.OPTIMIZING + "' # behind them");
    lines.add("");
    lines.add(
        "# Sets for a kind of start the AOT cache that it starts with (kind), its own options,"
            + " and");
    lines.add("# those for a heap that is ours.");
    lines.add("options_of() {");
    lines.add("  case $1 in");
    for (StartKind each : StartKind.values()) {
      lines.add("    " + each.word() + ")");
      lines.add("      kind=" + each.cache());
      lines.add("      own='" + String.join(" ", each.options()) + "'");
      lines.add("      heap='" + String.join(" ", each.heap()) + "'");
      lines.add("      ;;");
    }
    lines.add("  esac");
    lines.add("}");
    return lines;
  }
}
