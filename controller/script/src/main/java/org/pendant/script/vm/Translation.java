package org.pendant.script.vm;

/**
 * Translation policy: which functions {@link HotFunctions} translates. What a program does is the
 * same with each.
 */
enum Translation {
  /** Those that run often, in the background, while they are interpreted. */
  WHEN_HOT,

  /** All, before they run for the first time. */
  ALWAYS,

  NEVER
}
