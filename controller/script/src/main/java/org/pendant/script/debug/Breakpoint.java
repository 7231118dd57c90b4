package org.pendant.script.debug;

/**
 * Breakpoint: where a program is to stop, or to write a message without stopping.
 *
 * @param line 1-based line of the program's text
 * @param enabled whether it stops anything just now
 * @param condition an expression, computed where the program would stop; it stops when that is true
 *     or fails; empty text for always
 * @param fromHit the hit that is the first to stop the program, at least 1
 * @param message what is written to the log instead of stopping, with expressions in braces as in
 *     {@link LogMessage}; empty text for a breakpoint that stops
 */
public record Breakpoint(int line, boolean enabled, String condition, int fromHit, String message) {
  public Breakpoint {
    if (line < 1) {
      throw new IllegalArgumentException("line is " + line + ", must be at least 1");
    }
    if (fromHit < 1) {
      throw new IllegalArgumentException("fromHit is " + fromHit + ", must be at least 1");
    }
    condition = condition.strip();
    message = message.strip();
  }

  /** One that always stops. */
  public static Breakpoint at(int line) {
    return new Breakpoint(line, true, "", 1, "");
  }

  /** The same on another line. */
  public Breakpoint onLine(int other) {
    return new Breakpoint(other, enabled, condition, fromHit, message);
  }

  /** The same with a condition. */
  public Breakpoint when(String condition) {
    return new Breakpoint(line, enabled, condition, fromHit, message);
  }

  /** The same, passed over until hit {@code hit}. */
  public Breakpoint fromHit(int hit) {
    return new Breakpoint(line, enabled, condition, hit, message);
  }

  /** The same, writing a message instead of stopping; one that stops if it is empty. */
  public Breakpoint logging(String message) {
    return new Breakpoint(line, enabled, condition, fromHit, message);
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
    return new Breakpoint(line, effective, condition, fromHit, message);
  }
}
