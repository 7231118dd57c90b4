package org.pendant.testing.coverage;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.pendant.project.program.script.GeneratedScript.NodeLines;
import org.pendant.script.coverage.CoverageMap;
import org.pendant.script.coverage.CoverageSite;
import org.pendant.script.coverage.CoverageSite.Kind;

/** Reached nodes: the nodes of one tree that have statements, and the tests that reach them. */
final class ReachedNodes {
  private record Node(int number, String label, BitSet reached) {}

  /** The nodes that each line of a script belongs to. */
  static final class OfScript {
    private final Map<Integer, List<Node>> nodes = new HashMap<>();

    /** Test {@code number} came to {@code site} of the script. */
    void reach(CoverageSite site, int number) {
      if (site.kind() == Kind.STATEMENT) {
        nodes.getOrDefault(site.line(), List.of()).forEach(node -> node.reached().set(number));
      }
    }
  }

  private final SortedMap<Integer, Node> nodes = new TreeMap<>();

  /** The nodes of a script of the tree. */
  OfScript of(TreeOrigin tree, CoverageMap map) {
    OfScript script = new OfScript();
    for (CoverageSite site : map.sites()) {
      if (site.kind() == Kind.STATEMENT) {
        script.nodes.computeIfAbsent(site.line(), line -> at(tree, line));
      }
    }
    return script;
  }

  private List<Node> at(TreeOrigin tree, int line) {
    List<Node> found = new ArrayList<>();
    for (NodeLines place : tree.script().places()) {
      if (place.first() <= line && line <= place.last()) {
        String label = tree.labels().getOrDefault(place.key(), "");
        found.add(
            nodes.computeIfAbsent(place.number(), number -> new Node(number, label, new BitSet())));
      }
    }
    return found;
  }

  TreeCoverage coverage(String file, TestNames names) {
    return new TreeCoverage(
        file,
        nodes.values().stream()
            .map(node -> new NodeCoverage(node.number(), node.label(), names.of(node.reached())))
            .toList());
  }
}
