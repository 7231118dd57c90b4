package org.pendant.desktop.ports;

import java.util.Locale;

/**
 * Traffic of a connection until now.
 *
 * @param atNs when, by the clock
 */
record Traffic(long atNs, long inBytes, long outBytes, long inMessages, long outMessages) {
  private static final double SECOND_NS = 1e9;

  /** What has come since {@code before}, each second. */
  String in(Traffic before) {
    double seconds = (atNs - before.atNs) / SECOND_NS;
    return rate((inMessages - before.inMessages) / seconds, (inBytes - before.inBytes) / seconds);
  }

  /** What went since {@code before}, each second. */
  String out(Traffic before) {
    double seconds = (atNs - before.atNs) / SECOND_NS;
    return rate(
        (outMessages - before.outMessages) / seconds, (outBytes - before.outBytes) / seconds);
  }

  private static String rate(double messages, double bytes) {
    return bytes < 0.5
        ? ""
        : String.format(Locale.ROOT, "%.0f/s, %s/s", Math.ceil(messages), size((long) bytes));
  }

  /** A number of bytes, in three digits or so. */
  static String size(long bytes) {
    if (bytes < 1_000) {
      return bytes + " B";
    }
    return bytes < 1_000_000
        ? String.format(Locale.ROOT, "%.1f kB", bytes / 1e3)
        : String.format(Locale.ROOT, "%.1f MB", bytes / 1e6);
  }
}
