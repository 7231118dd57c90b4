package org.pendant.controller.message;

/**
 * Prompts to the operator: what the screen shows and asks. Both kinds count by the same numbers.
 *
 * @param popups the popups on the screen
 * @param questions the questions that wait for an answer
 */
public record OperatorPrompts(OpenPopups popups, PromptQueue questions) {

  /** No prompts yet. */
  public static OperatorPrompts none(Operator operator, MessageLog log) {
    PromptNumbers numbers = new PromptNumbers();
    return new OperatorPrompts(
        new OpenPopups(operator, log, numbers), new PromptQueue(operator, log, numbers));
  }
}
