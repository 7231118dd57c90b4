package org.pendant.protocols;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;

/**
 * Port of this computer that refuses every connection: it is bound, so that no other process gets
 * it meanwhile, and nothing listens.
 */
public final class ClosedPort implements AutoCloseable {
  private final Socket bound = new Socket();

  /** Takes a free one. */
  public ClosedPort() throws IOException {
    bound.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
  }

  /** Its number. */
  public int number() {
    return bound.getLocalPort();
  }

  @Override
  public void close() throws IOException {
    bound.close();
  }
}
