package org.pendant.desktop.log;

import java.util.Optional;

/** Log places: where messages of programs come from, as people know these places. */
@FunctionalInterface
public interface LogPlaces {
  /**
   * A line of a program that ran.
   *
   * @param timeS when the message was written, robot time, s
   * @param source name of the text that ran
   * @param line from 1
   * @return empty if it is not known
   */
  Optional<LogPlace> of(double timeS, String source, int line);
}
