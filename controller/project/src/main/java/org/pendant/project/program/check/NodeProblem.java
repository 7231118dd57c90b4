package org.pendant.project.program.check;

/**
 * Node problem: why a program cannot run yet, or what people should know about a node.
 *
 * @param key of the node that has to be changed
 * @param field of its form that it is about, as the component of the step's record is called; empty
 *     for the node as a whole
 * @param message what is missing or wrong, and what would be right
 * @param blocks whether the program cannot run, otherwise it is only a remark
 */
public record NodeProblem(long key, String field, String message, boolean blocks) {

  /** A problem that keeps the program from running. */
  public NodeProblem(long key, String field, String message) {
    this(key, field, message, true);
  }
}
