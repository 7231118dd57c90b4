package org.pendant.script.function;

import org.pendant.script.value.LongOperation;

/**
 * Outcome of a call: what a built-in function did: answered at once, began something long, or
 * waits.
 */
public sealed interface Outcome permits Outcome.Answered, Outcome.Begun, Wait {

  /** The call is run once more with the result of {@code operation}, see {@link Call#resume}. */
  record Begun(LongOperation operation) implements Outcome {}

  /** The answer stands in the call's result. */
  enum Answered implements Outcome {
    ANSWERED
  }
}
