package org.pendant.controller.message;

import java.util.List;

/** Operator: answers when a program asks for something. */
public sealed interface Operator {

  /** A person, or a program in its place, answers by commands. */
  record Present() implements Operator {}

  /**
   * Nobody is there: popups go on at once, questions get a prepared answer or fail.
   *
   * @param answers in the order in which they are used
   */
  record Absent(List<PreparedAnswer> answers) implements Operator {
    /** Copies the list. */
    public Absent {
      answers = List.copyOf(answers);
    }
  }

  /** Nobody answers beforehand: a person will, through a command. */
  static Operator present() {
    return new Present();
  }

  /** There is no screen: popups go on at once, questions get the prepared answers. */
  static Operator headless(List<PreparedAnswer> answers) {
    return new Absent(answers);
  }
}
