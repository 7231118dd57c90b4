package org.pendant.protocols.script;

import java.nio.ByteBuffer;
import org.pendant.protocols.net.Session;

/**
 * A client that nobody listens to.
 *
 * @param left runs when it has gone
 */
record ReadOnlySession(Runnable left) implements Session {
  @Override
  public void received(ByteBuffer bytes) {
    bytes.position(bytes.limit());
  }

  @Override
  public void closed() {
    left.run();
  }
}
