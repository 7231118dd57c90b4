package org.pendant.protocols.hostile;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.util.Random;

/** Connects, sends what it should not, and leaves in one of the ways in which peers leave. */
final class HostilePeer {
  private static final int GIVE_UP_MS = 30_000;

  /** As many packets a connection at most, most of them with a length that is right. */
  private static final int MAX_PACKETS = 200;

  private final InetAddress host;
  private final int port;
  private final Dialect dialect;
  private final Random random;
  private final byte[] rubbish = new byte[1 << 14];

  HostilePeer(InetAddress host, int port, Dialect dialect, long seed) {
    this.host = host;
    this.port = port;
    this.dialect = dialect;
    random = new Random(seed);
  }

  /**
   * Sends packets, connection after connection.
   *
   * @throws IOException if a connection is neither answered nor ended
   */
  void send(int packets) throws IOException {
    for (int sent = 0; sent < packets; ) {
      int count = Math.min(packets - sent, random.nextInt(1, MAX_PACKETS));
      ByteArrayOutputStream stream = new ByteArrayOutputStream();
      for (int i = 1; i < count; i++) {
        stream.writeBytes(dialect.withinFrame(random));
      }
      stream.writeBytes(dialect.anything(random));
      converse(stream.toByteArray());
      sent += count;
    }
  }

  private void converse(byte[] bytes) throws IOException {
    try (Socket socket = new Socket(host, port)) {
      socket.setSoTimeout(GIVE_UP_MS);
      socket.setTcpNoDelay(true);
      int cut = random.nextInt(bytes.length + 1);
      socket.getOutputStream().write(bytes, 0, cut);
      socket.getOutputStream().write(bytes, cut, bytes.length - cut);
      if (random.nextInt(4) == 0) {
        // gone without a word: the other side finds its connection reset
        socket.setSoLinger(true, 0);
        return;
      }
      socket.shutdownOutput();
      while (socket.getInputStream().read(rubbish) >= 0) {
        // until the other side has understood that nothing more comes
      }
    } catch (SocketException e) {
      // disconnected in the middle, which is one of the right answers
      return;
    }
  }
}
