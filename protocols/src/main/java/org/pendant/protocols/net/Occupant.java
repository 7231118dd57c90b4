package org.pendant.protocols.net;

import java.net.InetAddress;

/** Occupant of one of the places of a port. */
interface Occupant {
  /** Where it is. */
  InetAddress address();

  /**
   * How silent it is.
   *
   * @param nowNs by the clock that it was told of
   */
  Silence silence(long nowNs);
}
