package org.pendant.controller.message;

import java.util.Map;
import java.util.Optional;

/** Who answers when a program asks for something. */
public interface Operator {

  /** Whether a blocking popup is answered with "continue" at once. */
  boolean continuesAtOnce(Popup popup);

  /** The answer to a question with this text, if it is known beforehand. */
  Optional<String> answerTo(String question);

  /** Nobody answers beforehand: a person will, through a command. */
  static Operator present() {
    return new Operator() {
      @Override
      public boolean continuesAtOnce(Popup popup) {
        return false;
      }

      @Override
      public Optional<String> answerTo(String question) {
        return Optional.empty();
      }
    };
  }

  /** There is no screen: popups go on at once, questions get the prepared answers. */
  static Operator headless(Map<String, String> answers) {
    Map<String, String> prepared = Map.copyOf(answers);
    return new Operator() {
      @Override
      public boolean continuesAtOnce(Popup popup) {
        return true;
      }

      @Override
      public Optional<String> answerTo(String question) {
        return Optional.ofNullable(prepared.get(question));
      }
    };
  }
}
