package org.pendant.script.function;

/**
 * Foreseen operation: something that a thread will begin and that takes time, as look-ahead finds
 * it.
 */
public interface Foreseen {
  /** Whether looking further ahead is of no use: nothing before this depends on what follows it. */
  boolean last();
}
