package org.pendant.sweep;

import java.util.List;
import java.util.Optional;
import org.pendant.sweep.run.SweepResult;

/** Sweep listener: hears how a sweep goes, in the thread that runs it. */
@FunctionalInterface
public interface SweepListener {
  /** Who wants to hear nothing. */
  SweepListener NONE = (result, row) -> {};

  /**
   * It begins.
   *
   * @param done how many runs have a row already
   * @param size how many there are in all; of a search at most
   */
  default void begin(long done, long size) {}

  /**
   * A run has ended and is in the table; the order is that of the rows.
   *
   * @param row what the result has in each column
   */
  void take(SweepResult result, List<Optional<Object>> row);
}
