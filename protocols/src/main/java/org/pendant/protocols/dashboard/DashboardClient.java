package org.pendant.protocols.dashboard;

import static org.pendant.protocols.dashboard.DashboardTexts.text;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import org.pendant.protocols.net.LineCutter;
import org.pendant.protocols.net.ProtocolException;

/**
 * Dashboard client: says lines to the dashboard of a controller, of Pendant's or of a real robot,
 * and hears their answers. One thread uses it.
 */
public final class DashboardClient implements Closeable {
  private static final String GREETING = "Connected: Universal Robots Dashboard Server";
  private static final int MAX_LINE = 1 << 16;

  /** A dashboard that has not answered by then is none. */
  private static final int ANSWER_MS = 10_000;

  private static final int CONNECT_MS = 5_000;

  private final Socket socket;
  private final LineCutter cutter = new LineCutter(MAX_LINE);
  private final Deque<String> unread = new ArrayDeque<>();
  private final byte[] buffer = new byte[1 << 12];

  private DashboardClient(Socket socket) {
    this.socket = socket;
  }

  /**
   * Connects and hears the greeting.
   *
   * @throws IOException if nothing is reached there, or something that is no dashboard
   */
  public static DashboardClient connect(InetSocketAddress address) throws IOException {
    DashboardClient client = new DashboardClient(new Socket());
    try {
      client.socket.connect(address, CONNECT_MS);
      client.socket.setTcpNoDelay(true);
      String said = client.line(CONNECT_MS);
      if (!said.startsWith(GREETING)) {
        throw new IOException(text("doesNotGreet"));
      }
      return client;
    } catch (IOException e) {
      client.close();
      throw e;
    }
  }

  /**
   * Says a line.
   *
   * @return the answer
   * @throws IOException if the connection is lost or there is no answer
   */
  public String ask(String line) throws IOException {
    unread.clear();
    socket.getOutputStream().write((line + "\n").getBytes(StandardCharsets.ISO_8859_1));
    return line(ANSWER_MS);
  }

  private String line(int patienceMs) throws IOException {
    long endNs = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(patienceMs);
    while (unread.isEmpty()) {
      long leftMs = TimeUnit.NANOSECONDS.toMillis(endNs - System.nanoTime());
      if (leftMs <= 0) {
        throw late(patienceMs);
      }
      socket.setSoTimeout((int) leftMs);
      try {
        int count = socket.getInputStream().read(buffer);
        if (count < 0) {
          throw new EOFException(text("hasClosed"));
        }
        unread.addAll(cutter.take(ByteBuffer.wrap(buffer, 0, count)));
      } catch (SocketTimeoutException e) {
        throw late(patienceMs);
      } catch (ProtocolException e) {
        throw new IOException(text("noDashboard", e.getMessage()), e);
      }
    }
    return unread.poll().strip();
  }

  private static SocketTimeoutException late(int patienceMs) {
    return new SocketTimeoutException(text("saysNothingWithin", patienceMs / 1000));
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
