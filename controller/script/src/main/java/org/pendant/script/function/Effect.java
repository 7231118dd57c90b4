package org.pendant.script.function;

/**
 * Effect of a built-in: what it does beyond its answer, and whether the answer would be the same a
 * little later: that decides what may be run ahead of the arm to see which moves come.
 */
public enum Effect {
  /** It answers from its arguments alone. */
  COMPUTES,

  /** It tells what is so now and stays so unless a client changes it: inputs, settings. */
  ASKS,

  /** It tells what is so in this frame, and will be otherwise in another: sensors, time. */
  SENSES,

  /** It tells where the move under way leads. */
  ASKS_GOAL,

  /**
   * It tells the outside something, which does not change what the thread does next; its answer, if
   * it has one, is whether that went well.
   */
  TELLS,

  /** It sets something, and tells {@link ProgramControl#foreseesSetting} so before. */
  SETS,

  /** It asks for a move. */
  MOVES,

  /**
   * It waits, changes something, or would answer otherwise later: nothing is known of what comes
   * after it.
   */
  CHANGES
}
