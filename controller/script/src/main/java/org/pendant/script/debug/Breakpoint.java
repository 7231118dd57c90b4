package org.pendant.script.debug;

/**
 * Breakpoint: where a program is to stop, or to write a message without stopping.
 *
 * @param line 1-based line of the program's text
 * @param enabled whether it stops anything just now
 * @param condition an expression, computed where the program would stop; it stops when that is true
 *     or fails; empty text for always
 * @param hits which hits stop the program
 * @param message what is written to the log instead of stopping, with expressions in braces as in
 *     {@link LogMessage}; empty text for a breakpoint that stops
 */
public record Breakpoint(
    int line, boolean enabled, String condition, HitRule hits, String message) {
  public Breakpoint {
    if (line < 1) {
      throw new IllegalArgumentException("line is " + line + ", must be at least 1");
    }
    condition = condition.strip();
    message = message.strip();
  }

  /** One that always stops. */
  public static Breakpoint at(int line) {
    return new Breakpoint(line, true, "", HitRule.ALWAYS, "");
  }

  /** The same on another line. */
  public Breakpoint onLine(int other) {
    return new Breakpoint(other, enabled, condition, hits, message);
  }

  /** The same with a condition. */
  public Breakpoint when(String condition) {
    return new Breakpoint(line, enabled, condition, hits, message);
  }

  /** The same, passed over until hit {@code hit}. */
  public Breakpoint fromHit(int hit) {
    return counting(HitRule.from(hit));
  }

  /** The same, at some hits only. */
  public Breakpoint counting(HitRule hits) {
    return new Breakpoint(line, enabled, condition, hits, message);
  }

  /** The same, writing a message instead of stopping; one that stops if it is empty. */
  public Breakpoint logging(String message) {
    return new Breakpoint(line, enabled, condition, hits, message);
  }

  /** Whether it writes a message instead of stopping. */
  public boolean logs() {
    return !message.isEmpty();
  }

  /** The same, without effect until it is set enabled again. */
  public Breakpoint disabled() {
    return enabled(false);
  }

  /** The same, with effect or without. */
  public Breakpoint enabled(boolean effective) {
    return new Breakpoint(line, effective, condition, hits, message);
  }
}
