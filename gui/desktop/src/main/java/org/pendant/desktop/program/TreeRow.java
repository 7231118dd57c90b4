package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.pendant.kit.text.Messages;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;

/**
 * Tree row: a node as a line of the screen.
 *
 * @param number of the node in the program, from 1
 * @param depth below the top, 0 for sections
 * @param off whether it or a node above it is suppressed
 * @param folded whether its children are hidden; only for nodes with children
 */
record TreeRow(ProgramNode node, int number, int depth, boolean off, boolean folded) {

  /** The rows of a tree, without what is below folded nodes. */
  static List<TreeRow> of(ProgramTree tree, Set<Long> folded) {
    List<TreeRow> rows = new ArrayList<>();
    int[] number = {0};
    tree.sections().forEach(each -> add(each, 0, false, true, number, folded, rows));
    return rows;
  }

  private static void add(
      ProgramNode node,
      int depth,
      boolean offAbove,
      boolean shown,
      int[] number,
      Set<Long> folded,
      List<TreeRow> rows) {
    number[0]++;
    boolean off = offAbove || node.suppressed();
    boolean closed = folded.contains(node.key()) && !node.children().isEmpty();
    if (shown) {
      rows.add(new TreeRow(node, number[0], depth, off, closed));
    }
    node.children()
        .forEach(each -> add(each, depth + 1, off, shown && !closed, number, folded, rows));
  }

  long key() {
    return node.key();
  }

  boolean hasChildren() {
    return !node.children().isEmpty();
  }

  /** What people read. */
  String label(NodeLabels labels) {
    return labels.of(node.step());
  }

  @Override
  public String toString() {
    String label = number + " " + NodeLabels.shown(node.step());
    return off ? Messages.joined(List.of(label, text("suppressed"))) : label;
  }
}
