package org.pendant.protocols.serve;

import java.util.List;
import org.pendant.protocols.net.TcpPort;

/** One or several ports that expose a controller. */
public interface Server extends AutoCloseable {
  /** The ports it listens at. */
  List<TcpPort> ports();

  /** Ends listening and all connections. */
  @Override
  default void close() {
    ports().forEach(TcpPort::close);
  }
}
