package org.pendant.protocols.xmlrpc;

import static org.pendant.protocols.xmlrpc.XmlRpcTexts.text;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.Optional;
import org.pendant.protocols.egress.HostPolicy;

/**
 * RPC connection: a TCP connection to one server, made when it is needed and kept. One thread at a
 * time uses it; every other may {@link #close} it.
 */
final class RpcConnection {
  /** Most bytes of an answer. */
  static final int MAX_BYTES = 1 << 22;

  private static final int CONNECT_MS = 2_000;

  /** How long a server may pause within an answer. Before it there is no limit (manual 8). */
  private static final int STALL_MS = 10_000;

  private final HostPolicy hostPolicy;
  private final String host;
  private final int port;
  private volatile Optional<Socket> socket = Optional.empty();
  private InputStream in = InputStream.nullInputStream();

  RpcConnection(HostPolicy hostPolicy, String host, int port) {
    this.hostPolicy = hostPolicy;
    this.host = host;
    this.port = port;
  }

  boolean connected() {
    return socket.isPresent();
  }

  /** Connects, if it is not. */
  void connect() throws IOException {
    if (!connected()) {
      Socket made = hostPolicy.connect(host, port, CONNECT_MS);
      in = new BufferedInputStream(made.getInputStream());
      socket = Optional.of(made);
    }
  }

  private Socket open() throws IOException {
    return socket.orElseThrow(() -> new EOFException(text("connectionClosed")));
  }

  void send(byte[] bytes) throws IOException {
    open().getOutputStream().write(bytes);
  }

  /** The next byte, or -1 at the end. */
  int read() throws IOException {
    try {
      return in.read();
    } catch (SocketTimeoutException e) {
      throw new IOException(text("stoppedInAnswer"), e);
    }
  }

  /** Waits for the first byte of an answer, as long as it takes; tells whether there is one. */
  boolean awaitAnswer() throws IOException {
    open().setSoTimeout(0);
    in.mark(1);
    boolean begun = in.read() >= 0;
    if (begun) {
      in.reset();
      open().setSoTimeout(STALL_MS);
    }
    return begun;
  }

  /** Exactly {@code count} bytes. */
  byte[] read(int count) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    for (int i = 0; i < count; i++) {
      bytes.write(orEnd(read()));
    }
    return bytes.toByteArray();
  }

  /** A byte that must not be the end. */
  static int orEnd(int read) throws IOException {
    if (read < 0) {
      throw new EOFException(text("closedInAnswer"));
    }
    return read;
  }

  /** Refuses an answer of more than {@link #MAX_BYTES}. */
  static void bound(long bytes) throws IOException {
    if (bytes > MAX_BYTES) {
      throw new IOException(text("answerTooLong", MAX_BYTES));
    }
  }

  /** Ends the connection; the next call makes another. */
  void close() {
    Optional<Socket> open = socket;
    socket = Optional.empty();
    if (open.isPresent()) {
      try {
        open.get().close();
      } catch (IOException e) {
        // it is of no use either way
      }
    }
  }
}
