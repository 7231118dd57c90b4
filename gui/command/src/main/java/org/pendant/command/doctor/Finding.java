package org.pendant.command.doctor;

/**
 * Finding: one thing about this computer.
 *
 * @param subject what it is about, such as {@code Java} or {@code Port 29999}
 * @param found what is there
 * @param advice what it means for Pendant, and what to do; empty where all is well
 */
public record Finding(Level level, String subject, String found, String advice) {

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
  public static Finding ok(String subject, String found) {
    return new Finding(Level.OK, subject, found, "");
  }

  /** Something is missing that not everybody needs. */
  public static Finding note(String subject, String found, String advice) {
    return new Finding(Level.NOTE, subject, found, advice);
  }

  /** Something does not work until it is mended. */
  public static Finding problem(String subject, String found, String advice) {
    return new Finding(Level.PROBLEM, subject, found, advice);
  }
}
