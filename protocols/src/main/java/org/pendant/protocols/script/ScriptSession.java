package org.pendant.protocols.script;

import static org.pendant.protocols.script.ReceivedScriptTexts.text;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.ProtocolException;
import org.pendant.protocols.net.Session;

/** Script session: what one client sends, item by item. */
final class ScriptSession implements Session {
  private final Client client;
  private final ScriptHandler scriptHandler;
  private final PeerLog log;
  private final ScriptFramer framer;

  /**
   * Who sends.
   *
   * @param mayControl whether it may control the robot, for as long as it stays
   * @param left runs when it has gone
   */
  record Client(Connection connection, boolean mayControl, Runnable left) {
    String name() {
      return connection.name();
    }
  }

  ScriptSession(Client client, ScriptHandler scriptHandler, PeerLog log, ScriptFramer framer) {
    this.client = client;
    this.scriptHandler = scriptHandler;
    this.log = log;
    this.framer = framer;
  }

  @Override
  public void received(ByteBuffer bytes) throws ProtocolException {
    for (Optional<ScriptItem> item = framer.next(bytes);
        item.isPresent();
        item = framer.next(bytes)) {
      if (client.mayControl()) {
        scriptHandler.accept(item.get(), client.name());
      } else {
        scriptHandler.refuse(client.name());
      }
    }
  }

  @Override
  public void closed() {
    client.left().run();
    if (framer.unfinished() > 0) {
      log.write(
          Level.WARNING, text("leftWithUnfinishedScript", client.name(), framer.unfinished()));
    }
    framer.close();
  }
}
