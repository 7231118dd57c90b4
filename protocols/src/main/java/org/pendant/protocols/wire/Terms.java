package org.pendant.protocols.wire;

import java.util.List;

/** Terms: what a client and its port have agreed on so far. */
public interface Terms {
  /** How often the client gets data, Hz; 0 for not. */
  double rateHz();

  /** What the client gets, by name. */
  List<String> reads();

  /** What only this client may write, by name. */
  List<String> writes();

  /** A dissector that goes on from here. */
  Dissector dissector();
}
