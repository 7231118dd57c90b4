package org.pendant.desktop.program;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.project.program.Placement;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;

/** Drop spots: where nodes are put that are dropped at a point of the tree. */
final class DropSpots {
  private DropSpots() {}

  /**
   * What a drop would do.
   *
   * @param spot where the nodes would go
   * @param into row of the node that they would go into, to be framed; -1 for a line between rows
   * @param line above which row a line is drawn; the number of rows for below the last
   * @param depth at which the line begins
   * @param refusal why they cannot go there; empty if they can
   */
  record Target(Spot spot, int into, int line, int depth, Optional<String> refusal) {}

  /**
   * The target of a drop.
   *
   * @param y in rows from the top: 2.5 is the middle of the third row
   * @param depth of the pointer from the left, in levels: between two rows it chooses among what
   *     ends there
   * @param nodes that are dragged
   * @param moved whether they are nodes of the tree and leave their places
   */
  static Target at(
      ProgramTree tree,
      List<TreeRow> rows,
      double y,
      double depth,
      List<ProgramNode> nodes,
      boolean moved) {
    int row = Math.clamp((int) Math.floor(y), 0, rows.size() - 1);
    double within = y - row;
    List<Target> targets = new ArrayList<>();
    TreeRow at = rows.get(row);
    boolean holds = Placement.holdsOthers(at.node().step()) || at.depth() == 0;
    if (holds && within >= 0.25 && within <= 0.75) {
      targets.add(into(tree, at, row, nodes, moved));
    }
    int gap = within < 0.5 ? row : row + 1;
    targets.addAll(between(tree, rows, gap, depth, nodes, moved));
    int other = within < 0.5 ? row + 1 : row;
    if (holds && (within < 0.25 || within > 0.75)) {
      targets.add(into(tree, at, row, nodes, moved));
    }
    targets.addAll(between(tree, rows, other, depth, nodes, moved));
    return targets.stream()
        .filter(each -> each.refusal().isEmpty())
        .findFirst()
        .orElse(targets.getFirst());
  }

  private static Target into(
      ProgramTree tree, TreeRow row, int number, List<ProgramNode> nodes, boolean moved) {
    Spot spot = new Spot(row.key(), row.node().children().size());
    return new Target(
        spot, number, number, row.depth(), TreeEdits.whyNot(tree, nodes, spot, moved));
  }

  /** Everything that ends, or begins, between two rows, the one nearest to the pointer first. */
  private static List<Target> between(
      ProgramTree tree,
      List<TreeRow> rows,
      int gap,
      double depth,
      List<ProgramNode> nodes,
      boolean moved) {
    List<Target> found = new ArrayList<>();
    if (gap < rows.size()) {
      TreeRow below = rows.get(gap);
      Spot behind = TreeEdits.behind(tree, below.key());
      Spot spot = new Spot(behind.parent(), behind.index() - 1);
      found.add(target(tree, spot, gap, below.depth(), nodes, moved));
    }
    int least = gap < rows.size() ? rows.get(gap).depth() : 0;
    if (gap > 0) {
      TreeRow above = rows.get(gap - 1);
      long key = above.key();
      for (int level = above.depth(); level >= least; level--) {
        found.add(target(tree, TreeEdits.behind(tree, key), gap, level, nodes, moved));
        key = tree.parentOf(key).orElse(ProgramTree.ROOT);
      }
    }
    found.sort((a, b) -> Double.compare(Math.abs(a.depth() - depth), Math.abs(b.depth() - depth)));
    return found;
  }

  private static Target target(
      ProgramTree tree, Spot spot, int line, int depth, List<ProgramNode> nodes, boolean moved) {
    return new Target(spot, -1, line, depth, TreeEdits.whyNot(tree, nodes, spot, moved));
  }
}
