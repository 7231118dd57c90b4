package org.pendant.script.function;

/**
 * What look-ahead along a program collects: something that takes time, and that a thread will
 * begin.
 */
public interface Foreseen {
  /** Whether it matters to nothing before it what comes after it. */
  boolean last();
}
