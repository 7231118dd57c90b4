package org.pendant.desktop.plot;

/**
 * Time window: the stretch of time that the charts show.
 *
 * @param endS its right edge, s
 * @param widthS its width, 0.05 to 600 s
 * @param live whether the right edge goes with the newest sample
 */
record TimeWindow(double endS, double widthS, boolean live) {
  /** Narrower than this nothing more is to be seen: six samples. */
  static final double NARROWEST_S = 0.05;

  static final double WIDEST_S = 600;

  /** What the screen begins with. */
  static final TimeWindow START = new TimeWindow(0, 30, true);

  double beginS() {
    return endS - widthS;
  }

  /** The window when the newest sample is of time {@code newestS}. */
  TimeWindow at(double newestS) {
    return live ? new TimeWindow(newestS, widthS, true) : this;
  }

  /** As wide as wanted, to the same right edge. */
  TimeWindow withWidth(double seconds) {
    return new TimeWindow(endS, Math.clamp(seconds, NARROWEST_S, WIDEST_S), live);
  }

  /** Stands still, or goes with the newest sample. */
  TimeWindow withLive(boolean wanted) {
    return new TimeWindow(endS, widthS, wanted);
  }

  /**
   * Narrower or wider; what is under the pointer stays there, unless the window is live: then its
   * right edge does.
   *
   * @param factor of the width, below 1 for narrower
   * @param place of the pointer, 0 for the left edge to 1 for the right one
   */
  TimeWindow zoomed(double factor, double place) {
    double width = Math.clamp(widthS * factor, NARROWEST_S, WIDEST_S);
    double fixed = live ? 1 : place;
    return new TimeWindow(endS - (1 - fixed) * widthS + (1 - fixed) * width, width, live);
  }

  /** Moved by a share of its width, to later times where positive; stands still then. */
  TimeWindow moved(double share) {
    return new TimeWindow(endS + share * widthS, widthS, false);
  }

  /** From one time to another; stands still then. */
  TimeWindow between(double fromS, double toS) {
    double width = Math.clamp(Math.abs(toS - fromS), NARROWEST_S, WIDEST_S);
    return new TimeWindow(Math.min(fromS, toS) + width, width, false);
  }

  /** Where a time is, 0 at the left edge to 1 at the right one. */
  double placeOf(double timeS) {
    return (timeS - beginS()) / widthS;
  }

  /** The time at a place, 0 for the left edge to 1 for the right one. */
  double timeAt(double place) {
    return beginS() + place * widthS;
  }
}
