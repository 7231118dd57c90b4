package org.pendant.script.debug;

/**
 * Breakpoint: where a program is to stop.
 *
 * @param line 1-based line of the program's text
 * @param enabled whether it stops anything just now
 * @param condition an expression, computed where the program would stop; it stops when that is true
 *     or fails; empty text for always
 * @param fromHit the hit that is the first to stop the program, at least 1
 */
public record Breakpoint(int line, boolean enabled, String condition, int fromHit) {
  public Breakpoint {
    if (line < 1) {
      throw new IllegalArgumentException("line is " + line + ", must be at least 1");
    }
    if (fromHit < 1) {
      throw new IllegalArgumentException("fromHit is " + fromHit + ", must be at least 1");
    }
    condition = condition.strip();
  }

  /** One that always stops. */
  public static Breakpoint at(int line) {
    return new Breakpoint(line, true, "", 1);
  }

  /** The same with a condition. */
  public Breakpoint when(String condition) {
    return new Breakpoint(line, enabled, condition, fromHit);
  }

  /** The same, passed over until hit {@code hit}. */
  public Breakpoint fromHit(int hit) {
    return new Breakpoint(line, enabled, condition, hit);
  }

  /** The same, without effect until it is set enabled again. */
  public Breakpoint disabled() {
    return new Breakpoint(line, false, condition, fromHit);
  }
}
