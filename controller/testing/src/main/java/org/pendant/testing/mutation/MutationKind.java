package org.pendant.testing.mutation;

/** Mutation kind: what kind of mistake a mutation is. */
public enum MutationKind {
  /** Another comparison: {@code <} for {@code <=}, {@code ==} for {@code !=}. */
  COMPARISON("comparison"),
  /** A condition of {@code if}, {@code elif} or {@code while} the other way round. */
  CONDITION("condition"),
  /** {@code and} for {@code or}. */
  LOGIC("logic"),
  /** {@code +} for {@code -}, {@code *} for {@code /}. */
  ARITHMETIC("arithmetic"),
  /** A number that is one, or a tenth, larger; {@code True} for {@code False}. */
  CONSTANT("constant"),
  /** A move that is left out. */
  MOVE_DROPPED("move dropped"),
  /** Another call that is left out. */
  CALL_DROPPED("call dropped"),
  /** The neighbouring input or output, or the other level. */
  IO_SWAPPED("I/O swapped"),
  /** Twice the speed, acceleration, time or blend radius. */
  SPEED("speed"),
  /** Twice the mass. */
  PAYLOAD("payload"),
  /** A function that answers something else. */
  RETURN("return value");

  private final String text;

  MutationKind(String text) {
    this.text = text;
  }

  /** What people call it. */
  public String text() {
    return text;
  }
}
