package org.pendant.testing.mutation;

/** Mutant status: what came of a mutation. */
public enum MutantStatus {
  /** A test was red with it. */
  KILLED,
  /** With it a test took far longer than usual. */
  TIMED_OUT,
  /** Every test that reaches it was green. */
  SURVIVED,
  /** No test reaches it. */
  NOT_COVERED,
  /** The text is no program with it; it does not count. */
  NOT_COMPILED;

  /** Whether the tests have noticed. */
  public boolean detected() {
    return this == KILLED || this == TIMED_OUT;
  }
}
