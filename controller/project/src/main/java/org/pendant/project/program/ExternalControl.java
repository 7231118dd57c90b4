package org.pendant.project.program;

import java.util.List;

/**
 * External Control: the node of the URCap of that name, by which a program hands the arm over to a
 * driver: its script is asked for when the program starts.
 */
public final class ExternalControl {
  /** What the node is called in files of PolyScope. */
  public static final String TYPE = "External Control";

  private ExternalControl() {}

  /** Whether a step is such a node, and nothing was typed in that stands in for it. */
  public static boolean is(Step step) {
    return step instanceof ForeignStep.Contributed urcap
        && urcap.type().equals(TYPE)
        && urcap.stub().isEmpty();
  }

  /** How many of them a program has that are not suppressed. */
  public static int count(ProgramTree tree) {
    return count(tree.sections());
  }

  private static int count(List<ProgramNode> nodes) {
    return nodes.stream()
        .filter(each -> !each.suppressed())
        .mapToInt(each -> (is(each.step()) ? 1 : 0) + count(each.children()))
        .sum();
  }
}
