package org.pendant.protocols.socket;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.controller.external.ReceivedBytes;

/**
 * Script socket: one TCP connection of a script. A thread connects and then receives, another one
 * sends; the frame loop only touches what lies between.
 */
final class ScriptSocket implements ExternalSocket {
  /** How long a connection may take; the script itself gives up earlier. */
  static final int CONNECT_MS = 10_000;

  /** Most bytes that wait to be sent. */
  static final int MAX_UNSENT = 1 << 20;

  private static final int OBJECT_BYTES = 48;

  /** How long the last bytes have to go out. */
  private static final long LAST_BYTES_MS = 2_000;

  /** How long the peer has to close its side; then what it still sends is of no interest. */
  private static final long FAREWELL_MS = 200;

  /** After this nothing is sent; a message is never empty. */
  private static final byte[] END = {};

  private final ReceivedBytes received = new ReceivedBytes();
  private final BlockingQueue<byte[]> unsent = new LinkedBlockingQueue<>();
  private final AtomicInteger unsentBytes = new AtomicInteger();
  private final CountDownLatch sent = new CountDownLatch(1);
  private final CountDownLatch heard = new CountDownLatch(1);
  private final CountDownLatch over = new CountDownLatch(1);
  private final Object steps = new Object();
  private volatile Stage stage = Stage.CONNECTING;
  private volatile String failure = "";
  private final Thread receiving;
  private boolean closing;

  /** Waits for a connection. */
  interface Connecting {
    Socket connect() throws IOException;
  }

  /**
   * A socket that {@link #begin} connects.
   *
   * @param afterwards told when all is over
   */
  ScriptSocket(Connecting connecting, Consumer<ScriptSocket> afterwards) {
    receiving =
        Thread.ofVirtual().name("script socket").unstarted(() -> run(connecting, afterwards));
  }

  void begin() {
    receiving.start();
  }

  private void run(Connecting connecting, Consumer<ScriptSocket> afterwards) {
    try (Socket socket = connecting.connect()) {
      if (opened()) {
        Thread.ofVirtual().name("script socket sending").start(() -> sendAll(socket));
        receiveAll(socket);
        sent.await();
      }
    } catch (InterruptedException e) {
      // closed while connecting
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      failed(e);
    } finally {
      received.end();
      over.countDown();
      afterwards.accept(this);
    }
  }

  private boolean opened() {
    synchronized (steps) {
      if (!closing) {
        stage = Stage.OPEN;
      }
      return !closing;
    }
  }

  private void failed(IOException why) {
    synchronized (steps) {
      if (stage == Stage.CONNECTING) {
        failure = String.valueOf(why.getMessage());
        stage = Stage.FAILED;
      } else {
        stage = Stage.CLOSED;
      }
    }
  }

  private void receiveAll(Socket socket) throws InterruptedException {
    byte[] bytes = new byte[8192];
    boolean wanted = true;
    try {
      InputStream in = socket.getInputStream();
      for (int count = in.read(bytes); count >= 0; count = in.read(bytes)) {
        // what is not wanted is read nevertheless, or the peer would lose our last bytes
        wanted = wanted && received.append(bytes, count);
      }
    } catch (IOException e) {
      // reset by the peer, or closed by us: nothing goes either way any more
      lost();
    } finally {
      received.end();
      heard.countDown();
    }
  }

  private void lost() {
    stage = Stage.CLOSED;
    unsent.add(END);
  }

  private void sendAll(Socket socket) {
    try {
      OutputStream out = socket.getOutputStream();
      for (byte[] bytes = unsent.take(); bytes.length > 0; bytes = unsent.take()) {
        out.write(bytes);
        unsentBytes.addAndGet(-size(bytes));
      }
      socket.shutdownOutput();
    } catch (IOException e) {
      lost();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      sent.countDown();
    }
  }

  @Override
  public Stage stage() {
    return stage;
  }

  @Override
  public String failure() {
    return failure;
  }

  @Override
  public boolean send(byte[] bytes) {
    if (stage != Stage.OPEN || bytes.length == 0) {
      return stage == Stage.OPEN;
    }
    if (unsentBytes.addAndGet(size(bytes)) > MAX_UNSENT) {
      unsentBytes.addAndGet(-size(bytes));
      return false;
    }
    return unsent.add(bytes);
  }

  /** What waiting bytes take: of short ones the object is the larger part. */
  private static int size(byte[] bytes) {
    return OBJECT_BYTES + bytes.length;
  }

  @Override
  public ReceivedBytes received() {
    return received;
  }

  @Override
  public void close() {
    Stage before;
    synchronized (steps) {
      if (closing) {
        return;
      }
      closing = true;
      before = stage;
      stage = Stage.CLOSED;
    }
    received.abandon();
    unsent.add(END);
    if (before == Stage.CONNECTING) {
      receiving.interrupt();
    } else {
      Thread.ofVirtual().name("script socket closing").start(this::sayFarewell);
    }
  }

  /** Ends the receiving thread, whose end closes the socket. */
  private void sayFarewell() {
    try {
      if (sent.await(LAST_BYTES_MS, TimeUnit.MILLISECONDS)) {
        heard.await(FAREWELL_MS, TimeUnit.MILLISECONDS);
      }
      receiving.interrupt();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Waits until a socket that was closed is over. */
  void awaitEnd() {
    try {
      over.await(LAST_BYTES_MS + 2 * FAREWELL_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
