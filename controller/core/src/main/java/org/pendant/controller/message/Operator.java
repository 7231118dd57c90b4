package org.pendant.controller.message;

import java.util.List;

/** Operator: answers when a program asks for something. */
public sealed interface Operator {

  /** A person, or a program in its place, answers by commands. */
  record Present() implements Operator {}

  /**
   * No operator is there: popups close at once, questions get a prepared answer or fail.
   *
   * @param answers in the order in which they are used
   */
  record Absent(List<PreparedAnswer> answers) implements Operator {
    /** Copies the list. */
    public Absent {
      answers = List.copyOf(answers);
    }
  }

  /** No answer is prepared: a person will give it, through a command. */
  static Operator present() {
    return new Present();
  }

  /** There is no screen: popups close at once, questions get the prepared answers. */
  static Operator headless(List<PreparedAnswer> answers) {
    return new Absent(answers);
  }
}
