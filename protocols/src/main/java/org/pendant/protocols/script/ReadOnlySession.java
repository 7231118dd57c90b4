package org.pendant.protocols.script;

import java.nio.ByteBuffer;
import org.pendant.protocols.net.Session;

/**
 * Read-only session: a client whose input is ignored.
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
