package org.pendant.controller.message;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Scripted answers: replies to the operator prompts of an unattended run, in their order. */
final class ScriptedAnswers {
  private final List<PreparedAnswer> left;

  ScriptedAnswers(List<PreparedAnswer> answers) {
    left = new ArrayList<>(answers);
  }

  /**
   * The value for a question: of the answers that name it the next one, and their last one from
   * then on; without such the next one in order, which is used up then.
   */
  Optional<String> next(String question) {
    List<PreparedAnswer> named =
        left.stream().filter(each -> each.valueFor(question).isPresent()).toList();
    if (!named.isEmpty()) {
      PreparedAnswer first = named.getFirst();
      if (named.size() > 1) {
        left.remove(first);
      }
      return first.valueFor(question);
    }
    Optional<PreparedAnswer> inOrder =
        left.stream().filter(each -> each.valueInOrder().isPresent()).findFirst();
    inOrder.ifPresent(left::remove);
    return inOrder.flatMap(PreparedAnswer::valueInOrder);
  }
}
