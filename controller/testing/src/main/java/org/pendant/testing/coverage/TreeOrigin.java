package org.pendant.testing.coverage;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.StepNames;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.script.GeneratedScript;

/**
 * Tree origin: the program tree that a script was generated from.
 *
 * @param file its name as it was given
 * @param script what was compiled
 * @param labels of the nodes, by key
 * @param lines of the nodes in the file, by key; empty for a file whose lines mean nothing to
 *     people, of which only nodes are reported
 * @param text the lines of the file; empty as {@code lines} is
 */
public record TreeOrigin(
    String file,
    GeneratedScript script,
    Map<Long, String> labels,
    Map<Long, Integer> lines,
    List<String> text)
    implements LineOrigin {
  public TreeOrigin {
    labels = Map.copyOf(labels);
    lines = Map.copyOf(lines);
    text = List.copyOf(text);
  }

  /**
   * The tree of a file.
   *
   * @param script that was compiled: {@link TreeFile#script()}
   */
  public static TreeOrigin of(TreeFile tree, GeneratedScript script) {
    Map<Long, String> labels = new HashMap<>();
    for (ProgramNode node : tree.tree().nodes()) {
      labels.put(node.key(), StepNames.label(node));
    }
    return new TreeOrigin(
        tree.name(), script, labels, tree.nodeLines(), tree.content().lines().toList());
  }

  /** The line of the innermost node that a line of the script belongs to. */
  @Override
  public Optional<Place> of(int line) {
    return script
        .at(line)
        .map(GeneratedScript.NodeLines::key)
        .map(lines::get)
        .map(each -> new Place(file, each));
  }
}
