package org.pendant.testing.coverage;

import java.util.List;

/**
 * Tree coverage: a program tree.
 *
 * @param file its name as it was given
 * @param nodes that generate statements, in the order of the tree
 */
public record TreeCoverage(String file, List<NodeCoverage> nodes) {
  public TreeCoverage {
    nodes = List.copyOf(nodes);
  }

  /** How many nodes were reached. */
  public Share share() {
    return Share.of(nodes, node -> new Share(node.reached() ? 1 : 0, 1));
  }
}
