package org.pendant.project.program;

import java.util.List;

/**
 * Program node with all that is below it; immutable.
 *
 * @param key tells it from all other nodes of its tree, also after it has moved or changed; means
 *     nothing outside of the running Pendant
 * @param suppressed whether it and all below generate nothing
 */
public record ProgramNode(long key, Step step, boolean suppressed, List<ProgramNode> children) {
  public ProgramNode {
    children = List.copyOf(children);
  }

  /** The same node with other children. */
  public ProgramNode withChildren(List<ProgramNode> others) {
    return new ProgramNode(key, step, suppressed, others);
  }

  /** The same node as another step. */
  public ProgramNode withStep(Step other) {
    return new ProgramNode(key, other, suppressed, children);
  }

  /** The same node, suppressed or not. */
  public ProgramNode withSuppressed(boolean wanted) {
    return new ProgramNode(key, step, wanted, children);
  }
}
