package org.pendant.protocols.server;

import java.util.List;
import org.pendant.protocols.net.TcpPort;

/** Server: one or several ports that expose a controller. */
public interface Server extends AutoCloseable {
  /** The ports it listens at. */
  List<TcpPort> ports();

  /** Those of its ports that could not be had; it does without them. */
  default List<MissingPort> missing() {
    return List.of();
  }

  /** Ends listening and all connections. */
  @Override
  default void close() {
    ports().forEach(TcpPort::close);
  }
}
