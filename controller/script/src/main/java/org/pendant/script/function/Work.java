package org.pendant.script.function;

/**
 * Work counter: counts what a program's instructions and built-ins take of its computing time and
 * memory; the machine settles it with the thread that they ran in.
 */
public final class Work {
  /** Less than this is not worth to be settled at once. */
  private static final int DUE_NS = 1000;

  private static final int DUE_BYTES = 8192;

  private long ns;
  private long bytes;

  /**
   * Counts computing time beside that of the call itself.
   *
   * @param more nanoseconds of a usual computer, roughly; not negative
   */
  public void charge(long more) {
    ns += more;
  }

  /**
   * Counts new values.
   *
   * @param more as {@link org.pendant.script.value.Value#sizeBytes} says
   */
  public void take(long more) {
    bytes += more;
  }

  /** Whether so much was counted that it has to be settled before anything else is done. */
  public boolean due() {
    return ns > DUE_NS || bytes > DUE_BYTES;
  }

  /** The computing time since the last call of this. */
  public int settleNs() {
    long settled = ns;
    ns = 0;
    return (int) Math.min(Integer.MAX_VALUE / 4, settled);
  }

  /** Whether any value was counted since the last {@link #settleBytes}. */
  public boolean tookBytes() {
    return bytes > 0;
  }

  /** The bytes of new values since the last call of this. */
  public long settleBytes() {
    long settled = bytes;
    bytes = 0;
    return settled;
  }
}
