package org.pendant.protocols.toolserial;

import static org.pendant.protocols.toolserial.ToolSerialTexts.text;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.Consumer;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.Session;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.Server;

/**
 * Tool serial server: the tool's serial line as a TCP port, whose clients are on the line, byte for
 * byte.
 */
public final class ToolSerialServer implements Server {
  /** Where people's programs look for it. */
  public static final int STANDARD_PORT = 54_321;

  private final TcpPort port;

  private ToolSerialServer(TcpPort port) {
    this.port = port;
  }

  /**
   * Begins to listen.
   *
   * @throws IOException if the port cannot be had
   */
  public static ToolSerialServer open(ToolSerialLine line, PortNumbers numbers, PeerLog log)
      throws IOException {
    return new ToolSerialServer(
        TcpPort.open(
            numbers.listening(text("portName"), STANDARD_PORT),
            connection -> new Member(line, connection),
            log));
  }

  /** A client that is on the line. */
  private static final class Member implements Session {
    private final ToolSerialLine line;
    private final Consumer<byte[]> hears;

    Member(ToolSerialLine line, Connection connection) {
      this.line = line;
      hears = connection::send;
      line.join(hears);
    }

    @Override
    public void received(ByteBuffer bytes) {
      byte[] sent = new byte[bytes.remaining()];
      bytes.get(sent);
      line.send(hears, sent);
    }

    @Override
    public void closed() {
      line.leave(hears);
    }
  }

  @Override
  public List<TcpPort> ports() {
    return List.of(port);
  }
}
