package org.pendant.desktop.timeline;

/**
 * Time range: the stretch of robot time that a timeline shows.
 *
 * @param fromS its left end, s
 * @param toS its right end, s; later than {@code fromS}
 */
record TimeRange(double fromS, double toS) {
  /** Twenty frames; a mouse can tell them from each other. */
  static final double MIN_S = 0.04;

  double widthS() {
    return toS - fromS;
  }

  /** Where a time is, 0 at the left end and 1 at the right one. */
  double share(double timeS) {
    return (timeS - fromS) / widthS();
  }

  double timeS(double share) {
    return fromS + share * widthS();
  }

  /** Shows {@code factor} times as much; {@code timeS} stays where it is. */
  TimeRange zoomed(double factor, double timeS) {
    double width = Math.max(MIN_S, widthS() * factor);
    double from = timeS - share(timeS) * width;
    return new TimeRange(from, from + width);
  }

  TimeRange moved(double byS) {
    return new TimeRange(fromS + byS, toS + byS);
  }

  /** The same width between two times; behind the later one only if there is not as much. */
  TimeRange within(double firstS, double lastS) {
    double from = Math.max(firstS, Math.min(fromS, lastS - widthS()));
    return new TimeRange(from, from + widthS());
  }

  /** As little moved as needed to have a time in sight. */
  TimeRange showing(double timeS) {
    double margin = widthS() / 20;
    if (timeS < fromS) {
      return moved(timeS - margin - fromS);
    }
    return timeS > toS ? moved(timeS + margin - toS) : this;
  }
}
