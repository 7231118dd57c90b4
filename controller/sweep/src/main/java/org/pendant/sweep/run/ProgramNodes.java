package org.pendant.sweep.run;

import java.util.Optional;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.StepNames;
import org.pendant.project.program.script.GeneratedScript;

/**
 * Program nodes: where lines of a generated script are in the tree that people know. Variants
 * change what is in lines, not where they are.
 */
public final class ProgramNodes {
  private final ProgramTree tree;
  private final GeneratedScript script;

  ProgramNodes(ProgramTree tree, GeneratedScript script) {
    this.tree = tree;
    this.script = script;
  }

  /**
   * A node.
   *
   * @param number as it stands beside the node in the tree
   * @param label as in the tree
   */
  public record Place(int number, String label) {}

  /** The innermost node that a line, from 1, belongs to. */
  public Optional<Place> at(int line) {
    return script
        .at(line)
        .flatMap(
            lines ->
                tree.find(lines.key())
                    .map(node -> new Place(lines.number(), StepNames.label(node))));
  }
}
