package org.pendant.sweep.engine;

import java.io.IOException;
import org.pendant.sweep.run.SweepResult;

/** Result sink: takes the results of variants, each once and in the order of their numbers. */
@FunctionalInterface
public interface ResultSink {
  /**
   * Takes one.
   *
   * @throws IOException if it cannot be kept; the engine then ends
   */
  void take(SweepResult result) throws IOException;
}
