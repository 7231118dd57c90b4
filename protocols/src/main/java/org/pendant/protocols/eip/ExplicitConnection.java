package org.pendant.protocols.eip;

/**
 * Explicit connection: one for messages; it belongs to a session and ends with it.
 *
 * @param id number of packets to the box
 * @param heardNs when the last message came, by the computer's clock
 */
record ExplicitConnection(int id, int session, OpenRequest request, long heardNs) {
  ExplicitConnection heardAt(long nowNs) {
    return new ExplicitConnection(id, session, request, nowNs);
  }

  boolean late(long nowNs) {
    return nowNs - heardNs > request.timeoutNs();
  }
}
