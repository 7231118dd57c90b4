package org.pendant.controller.message;

import java.util.Optional;

/** Pending prompt: a question to the operator without an answer yet. Owned by the frame loop. */
public final class PendingPrompt {
  private final Question question;
  private Optional<Answer> answer = Optional.empty();
  private Optional<String> refusal = Optional.empty();

  PendingPrompt(Question question) {
    this.question = question;
  }

  /** What is asked. */
  public Question question() {
    return question;
  }

  /** The answer, once there is one; of the kind that the question asks for. */
  public Optional<Answer> answer() {
    return answer;
  }

  /** Why there will never be an answer, as no operator could give it. */
  public Optional<String> refusal() {
    return refusal;
  }

  void answer(Answer given) {
    answer = Optional.of(given);
  }

  void refuse(String why) {
    refusal = Optional.of(why);
  }
}
