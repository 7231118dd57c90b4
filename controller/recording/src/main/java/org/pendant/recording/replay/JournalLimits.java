package org.pendant.recording.replay;

/**
 * Journal limits: how much a {@link Journal} keeps. What does not fit ends it: without the oldest
 * commands the others are worth nothing.
 *
 * @param mostCommands 1 or more
 * @param mostBytes about, as far as the commands themselves say how large they are
 */
public record JournalLimits(int mostCommands, long mostBytes) {
  /**
   * A million commands, 64 MB: six hours of a hand at the screen that moves the arm all the time.
   */
  public static final JournalLimits STANDARD = new JournalLimits(1_000_000, 64L << 20);

  /** Checks the numbers. */
  public JournalLimits {
    if (mostCommands < 1 || mostBytes < 1) {
      throw new IllegalArgumentException(
          "limits are " + mostCommands + " commands and " + mostBytes + " bytes, must be above 0");
    }
  }
}
