package org.pendant.controller.installation;

/**
 * Installation problem: something in an installation that cannot be so.
 *
 * @param field where, such as {@code activeTool} or {@code tools[1].name}
 * @param message what it is, and what would be right
 * @param blocks whether no controller can be set up with it; otherwise only programs cannot run
 *     that use what it is about
 */
public record InstallationProblem(String field, String message, boolean blocks) {
  /** Both, for people. */
  @Override
  public String toString() {
    return field + ": " + message;
  }
}
