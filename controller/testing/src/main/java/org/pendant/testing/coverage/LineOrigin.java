package org.pendant.testing.coverage;

import java.util.Optional;

/** Line origin: where the lines of a text that was compiled come from. */
@FunctionalInterface
public interface LineOrigin {
  /**
   * A line of a file.
   *
   * @param line 1-based
   */
  record Place(String file, int line) {}

  /** Where {@code line}, 1-based, comes from; empty for one that is not to be reported. */
  Optional<Place> of(int line);

  /** A text that is one file. */
  static LineOrigin file(String file) {
    return line -> Optional.of(new Place(file, line));
  }
}
