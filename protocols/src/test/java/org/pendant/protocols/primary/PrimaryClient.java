package org.pendant.protocols.primary;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.function.Predicate;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.script.RunningBox;

/** A client of a primary or secondary port that reads package after package. */
final class PrimaryClient implements AutoCloseable {
  private final Socket socket;
  private final DataInputStream in;

  /** A package without its size. */
  record Packet(int type, ByteBuffer bytes) {
    /** Type of a robot message, -1 for other packages. */
    int message() {
      return type == 20 ? bytes.get(14) : -1;
    }

    /** Everything behind byte {@code from} of the package. */
    String text(int from) {
      byte[] rest = new byte[bytes.capacity() - from];
      bytes.get(from, rest);
      return new String(rest, StandardCharsets.ISO_8859_1);
    }

    /** Whether it is a key message. */
    boolean key(String title, String text) {
      return message() == 7 && text(24).equals(title + text);
    }
  }

  PrimaryClient(TcpPort port) throws IOException {
    socket = new Socket(InetAddress.getLoopbackAddress(), port.number());
    socket.setSoTimeout(RunningBox.GIVE_UP_MS);
    in = new DataInputStream(socket.getInputStream());
  }

  void send(String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** Sends nothing more. */
  void finish() throws IOException {
    socket.shutdownOutput();
  }

  Packet next() throws IOException {
    int size = in.readInt();
    byte[] bytes = new byte[size];
    ByteBuffer.wrap(bytes).putInt(size);
    in.readFully(bytes, 4, size - 4);
    return new Packet(bytes[4], ByteBuffer.wrap(bytes));
  }

  /** The next package of that kind. */
  Packet next(Predicate<Packet> wanted) throws IOException {
    long giveUpNs = System.nanoTime() + RunningBox.GIVE_UP_MS * 1_000_000L;
    Packet found = next();
    while (!wanted.test(found)) {
      if (System.nanoTime() > giveUpNs) {
        throw new AssertionError("what was waited for did not come");
      }
      found = next();
    }
    return found;
  }

  /** The next robot message. */
  Packet nextMessage() throws IOException {
    return next(each -> each.type() == 20);
  }

  /** Waits until the other side has closed the connection. */
  void awaitDisconnection() throws IOException {
    in.skip(Long.MAX_VALUE);
    while (in.read() >= 0) {
      in.skip(Long.MAX_VALUE);
    }
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
