package org.pendant.desktop.plot;

import java.util.Locale;

/**
 * Cursors: two marked times.
 *
 * @param aS one time, s
 * @param bS the other, s
 */
record Cursors(double aS, double bS) {

  /** With the cursor moved that is nearer to where it goes. */
  Cursors nearestTo(double timeS) {
    return Math.abs(timeS - aS) <= Math.abs(timeS - bS)
        ? new Cursors(timeS, bS)
        : new Cursors(aS, timeS);
  }

  /** Both times and their difference as text. */
  String text() {
    return String.format(Locale.ROOT, "A %.3f s   B %.3f s   \u0394 %.3f s", aS, bS, bS - aS);
  }
}
