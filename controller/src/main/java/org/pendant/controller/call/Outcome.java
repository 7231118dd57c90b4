package org.pendant.controller.call;

/** What a built-in function did with a call: answered at once, or waits. */
public sealed interface Outcome permits Outcome.Answered, Wait {

  /** The answer stands in the call's result. */
  enum Answered implements Outcome {
    ANSWERED
  }
}
