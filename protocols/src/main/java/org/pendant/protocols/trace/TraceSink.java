package org.pendant.protocols.trace;

import java.io.Closeable;
import java.io.IOException;

/** Trace sink: takes what was traced, in its order, in one thread. */
interface TraceSink extends Closeable {
  /** Takes the next event. */
  void take(WireEvent event) throws IOException;

  /**
   * Events have found no room.
   *
   * @param count since the last call
   * @param epochUs now, us since 1970
   */
  void leftOut(long count, long epochUs) throws IOException;

  /** Puts what it has taken where others see it. */
  void flush() throws IOException;
}
