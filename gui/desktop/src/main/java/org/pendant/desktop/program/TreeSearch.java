package org.pendant.desktop.program;

import java.util.List;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.regex.Pattern;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;

/** Tree search: finds nodes by what they are called and by what stands in their fields. */
final class TreeSearch {
  private static final Pattern FIELD_NAMES = Pattern.compile("\\b\\w+(?:\\[|=(?!=))");

  private TreeSearch() {}

  /**
   * The keys of nodes that have a text in their label or their values, in order.
   *
   * @param labels what people call nodes
   */
  static List<Long> matches(ProgramTree tree, String text, NodeLabels labels) {
    String wanted = text.strip().toLowerCase(Locale.ROOT);
    if (wanted.isEmpty()) {
      return List.of();
    }
    return tree.nodes().stream()
        .filter(each -> matches(each, wanted, labels))
        .map(ProgramNode::key)
        .toList();
  }

  private static boolean matches(ProgramNode node, String wanted, NodeLabels labels) {
    return contains(labels.of(node.step()), wanted)
        || contains(NodeLabels.shown(node.step()), wanted)
        || contains(values(node), wanted);
  }

  private static boolean contains(String text, String wanted) {
    return text.toLowerCase(Locale.ROOT).contains(wanted);
  }

  /** What stands in the fields, without the names of the fields. */
  private static String values(ProgramNode node) {
    return FIELD_NAMES.matcher(node.step().toString()).replaceAll(" ");
  }

  /** The match behind a node, or before it, round the end of the program. */
  static OptionalLong next(ProgramTree tree, List<Long> matches, long from, boolean forward) {
    if (matches.isEmpty()) {
      return OptionalLong.empty();
    }
    List<Long> order = TreeEdits.keys(tree.nodes());
    int at = order.indexOf(from);
    int count = order.size();
    for (int i = 1; i <= count; i++) {
      long key = order.get(Math.floorMod(forward ? at + i : Math.max(at, 0) - i, count));
      if (matches.contains(key)) {
        return OptionalLong.of(key);
      }
    }
    return OptionalLong.empty();
  }
}
