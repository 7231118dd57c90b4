package org.pendant.desktop.timeline;

/** Moment places: what lines of programs that ran are called. */
@FunctionalInterface
public interface MomentPlaces {
  /**
   * Within a sentence, such as {@code line 12} or {@code node 3 Point}.
   *
   * @param timeS when the program ran, robot time, s
   * @param line from 1, of the text that ran
   */
  String of(double timeS, int line);
}
