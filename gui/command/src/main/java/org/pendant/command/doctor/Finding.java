package org.pendant.command.doctor;

/**
 * Finding: one thing about this computer.
 *
 * @param subject what it is about, such as {@code Java} or {@code Port 29999}
 * @param found what is there
 * @param advice what it means for Pendant, and what to do; empty where all is well
 */
public record Finding(Level level, FindingText subject, FindingText found, FindingText advice) {

  /** How bad it is. */
  public enum Level {
    /** All is well. */
    OK,
    /** Something is missing that not everybody needs, or works in another way. */
    NOTE,
    /** Something does not work until it is mended. */
    PROBLEM
  }

  /** All is well. */
  public static Finding ok(FindingText subject, FindingText found) {
    return new Finding(Level.OK, subject, found, FindingText.NONE);
  }

  /** Something is missing that not everybody needs. */
  public static Finding note(FindingText subject, FindingText found, FindingText advice) {
    return new Finding(Level.NOTE, subject, found, advice);
  }

  /** Something does not work until it is mended. */
  public static Finding problem(FindingText subject, FindingText found, FindingText advice) {
    return new Finding(Level.PROBLEM, subject, found, advice);
  }
}
