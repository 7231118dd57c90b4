package org.pendant.controller.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Prepared answers: what the operator of a test says when a program asks. */
public final class PreparedAnswers {
  private record Prepared(String question, Given given) {}

  /**
   * What an operator says.
   *
   * @param value as an operator types it
   * @param afterFrames so many frames after the question it comes into force, 1 or more
   */
  public record Given(String value, long afterFrames) {}

  private final List<Prepared> prepared = new ArrayList<>();
  private boolean popupsStay;

  PreparedAnswers() {}

  /**
   * Prepares an answer, to be used once.
   *
   * @param question part of the text that is asked; empty for whatever is asked next
   * @param given what is said then
   */
  public void add(String question, Given given) {
    prepared.add(new Prepared(question, given));
  }

  /** The first answer that is prepared for a question, which is used up by that. */
  public Optional<Given> take(String question) {
    for (int i = 0; i < prepared.size(); i++) {
      if (question.contains(prepared.get(i).question())) {
        return Optional.of(prepared.remove(i).given());
      }
    }
    return Optional.empty();
  }

  /** Whether popups stay on the screen until the test closes them, instead of closing at once. */
  public boolean popupsStay() {
    return popupsStay;
  }

  /** Has popups stay until the test closes them, or close at once as at first. */
  public void setPopupsStay(boolean stay) {
    popupsStay = stay;
  }
}
