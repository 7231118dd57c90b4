package org.pendant.project.program.urp;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.GeneratedScript.NodeLines;

/**
 * Shown nodes of a program of PolyScope X, which are only shown, and the lines of its script, which
 * run: remarks in the script say at which node it is.
 */
public final class ShownNodes {
  private static final Pattern REMARK = Pattern.compile("^(\\s*)# node ([1-9]\\d{0,8}) \"");
  private static final Pattern STATEMENT = Pattern.compile("\\s*[^\\s#].*");

  private final String[] lines;
  private final Map<Long, NodeLines> places = new HashMap<>();

  private ShownNodes(GeneratedScript script) {
    lines = script.text().split("\n", -1);
  }

  /** The remark that nodes begin with in the script. */
  static String remark(int number, String label) {
    return "# node " + number + " " + label;
  }

  /** Whether a node of a tree that {@link UrpxPrograms} has made is one of PolyScope X. */
  public static boolean isShown(ProgramTree tree, long key) {
    return shown(tree).stream().anyMatch(each -> holds(each, key));
  }

  private static boolean holds(ProgramNode node, long key) {
    return node.key() == key || node.children().stream().anyMatch(each -> holds(each, key));
  }

  private static List<ProgramNode> shown(ProgramTree tree) {
    return tree.sections().stream()
        .flatMap(each -> each.children().stream())
        .filter(each -> each.suppressed() && each.step() instanceof ActionStep.Folder)
        .toList();
  }

  /**
   * Adds the lines of the nodes that are shown to a script.
   *
   * @param tree as {@link UrpxPrograms} has made it
   * @param script of that tree; its own places come before those of the nodes that are shown
   */
  public static GeneratedScript placed(ProgramTree tree, GeneratedScript script) {
    ShownNodes nodes = new ShownNodes(script);
    List<ProgramNode> all = tree.nodes();
    nodes.find(all);
    List<NodeLines> places = new ArrayList<>(script.places());
    for (ProgramNode each : shown(tree)) {
      nodes.add(each, places);
    }
    return new GeneratedScript(script.text(), places, script.received(), script.names());
  }

  /** The lines from each remark to the next one beside it, or to the end of its block. */
  private void find(List<ProgramNode> all) {
    for (int i = 0; i < lines.length; i++) {
      Matcher remark = REMARK.matcher(lines[i]);
      int number = remark.lookingAt() ? Integer.parseInt(remark.group(2)) : 0;
      if (number > 0 && number <= all.size()) {
        int depth = remark.end(1);
        int last = i;
        while (last + 1 < lines.length && belongs(lines[last + 1], depth)) {
          last++;
        }
        long key = all.get(number - 1).key();
        places.putIfAbsent(key, new NodeLines(key, number, i + 1, last + 1));
      }
    }
  }

  private static boolean belongs(String line, int depth) {
    int indent = line.length() - line.stripLeading().length();
    return line.isBlank()
        || indent > depth
        || (indent == depth && !REMARK.matcher(line).lookingAt());
  }

  /** Adds a node that has lines and those below it; answers the last line of them all, or 0. */
  private int add(ProgramNode node, List<NodeLines> all) {
    int at = all.size();
    int last = 0;
    for (ProgramNode each : node.children()) {
      last = Math.max(last, add(each, all));
    }
    NodeLines own = places.get(node.key());
    if (own == null) {
      return last;
    }
    last = Math.max(last, own.last());
    int first = own.first();
    while (first < last && !STATEMENT.matcher(lines[first - 1]).matches()) {
      first++;
    }
    boolean runs = STATEMENT.matcher(lines[first - 1]).matches();
    all.add(at, new NodeLines(node.key(), own.number(), runs ? first : own.first(), last));
    return last;
  }
}
