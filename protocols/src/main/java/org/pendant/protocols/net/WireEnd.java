package org.pendant.protocols.net;

import java.net.InetSocketAddress;
import java.util.Optional;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Terms;

/** Wire end: our end of a connection, as a {@link WireTap} knows it. */
public interface WireEnd {
  /** The name of the port, or of what has connected. */
  String portName();

  /** This side of it. */
  InetSocketAddress local();

  /** Where the peer is. */
  InetSocketAddress peer();

  /** Whether this side has connected to the other one. */
  boolean outgoing();

  /** What was agreed on with the peer; empty where protocols have no such thing. */
  Optional<Terms> terms();

  /** A dissector for all of it, from its first byte. */
  Dissector dissector();
}
