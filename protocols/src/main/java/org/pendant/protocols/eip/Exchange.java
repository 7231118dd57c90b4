package org.pendant.protocols.eip;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;

/** Exchange: one explicit message and what goes with it besides the request itself. */
final class Exchange {
  private final InetSocketAddress peer;
  private final int session;
  private final List<PacketItem> sent;
  private final List<PacketItem> added = new ArrayList<>();

  /**
   * A message.
   *
   * @param peer who asks
   * @param session number of its session
   * @param sent all items of the message
   */
  Exchange(InetSocketAddress peer, int session, List<PacketItem> sent) {
    this.peer = peer;
    this.session = session;
    this.sent = List.copyOf(sent);
  }

  InetSocketAddress peer() {
    return peer;
  }

  int session() {
    return session;
  }

  List<PacketItem> sent() {
    return sent;
  }

  /** Has the answer carry one more item. */
  void add(PacketItem item) {
    added.add(item);
  }

  /** What the answer carries besides itself. */
  List<PacketItem> added() {
    return List.copyOf(added);
  }
}
