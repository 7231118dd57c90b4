package org.pendant.fuzz;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/** One client that says something, well or badly, and leaves in one of the ways that there are. */
final class RandomSession {
  private static final int MAX_MESSAGES = 12;
  private static final int PATIENCE_MS = 20_000;
  private static final int GLANCE_MS = 5;
  private static final int MAX_SLOW_BYTES = 40;
  private static final int LONG = 1 << 14;

  /** What is done to a conversation. */
  private enum Manner {
    RIGHT,
    CUT,
    MUTATED,
    REORDERED,
    REPEATED,
    SLOW,
    NOISE,
    SILENT
  }

  /** How it ends. */
  private enum Leaving {
    HALF_CLOSED,
    CLOSED,
    RESET,
    DEAF
  }

  private final InetAddress host;
  private final int port;
  private final Vocabulary vocabulary;
  private final Random random;
  private final Manner manner;
  private final Leaving leaving;
  private final byte[] rubbish = new byte[LONG];

  RandomSession(InetAddress host, int port, Vocabulary vocabulary, long seed) {
    this.host = host;
    this.port = port;
    this.vocabulary = vocabulary;
    random = new Random(seed);
    manner = Manner.values()[random.nextInt(Manner.values().length)];
    leaving = Leaving.values()[random.nextInt(Leaving.values().length)];
  }

  /** What it does, for people. */
  String description() {
    return manner + " and " + leaving;
  }

  /**
   * Speaks and leaves.
   *
   * @throws IOException if nobody takes the connection, or what has ended is not ended
   */
  void run() throws IOException {
    try (Socket socket = new Socket(host, port)) {
      socket.setTcpNoDelay(true);
      try {
        speak(socket);
        leave(socket);
      } catch (SocketTimeoutException e) {
        throw new IOException("the port does not end a connection that is half-closed", e);
      } catch (SocketException e) {
        // disconnected in the middle, which is one of the right answers
        return;
      }
    }
  }

  private void speak(Socket socket) throws IOException {
    byte[] session = new byte[0];
    for (byte[] each : conversation()) {
      byte[] message = each.clone();
      if (vocabulary.numbered() && session.length == 4 && message.length >= 8) {
        System.arraycopy(session, 0, message, 4, session.length);
      }
      write(message, socket);
      if (vocabulary.numbered() && session.length == 0) {
        session = sessionNumber(socket);
      } else if (leaving != Leaving.DEAF && random.nextInt(3) == 0) {
        glance(socket);
      }
    }
  }

  private List<byte[]> conversation() {
    List<byte[]> all = vocabulary.messages();
    List<byte[]> said = new ArrayList<>();
    int count = random.nextInt(1, MAX_MESSAGES);
    for (int i = 0; i < all.size() && said.size() < count; i++) {
      if (random.nextInt(3) != 0) {
        said.add(all.get(i));
      }
    }
    switch (manner) {
      case RIGHT, SLOW -> {}
      case CUT -> said.replaceAll(this::cut);
      case MUTATED -> said.replaceAll(this::mutated);
      case REORDERED -> Collections.shuffle(said, random);
      case REPEATED -> said.addAll(List.copyOf(said));
      case NOISE -> said.add(noise());
      case SILENT -> said.clear();
    }
    return said;
  }

  private byte[] cut(byte[] message) {
    return random.nextInt(3) == 0
        ? Arrays.copyOf(message, random.nextInt(message.length + 1))
        : message;
  }

  private byte[] mutated(byte[] message) {
    byte[] changed = message.clone();
    for (int i = random.nextInt(1, 4); i > 0; i--) {
      changed[random.nextInt(changed.length)] = (byte) random.nextInt(256);
    }
    return changed;
  }

  private byte[] noise() {
    byte[] noise = new byte[random.nextInt(1, LONG)];
    random.nextBytes(noise);
    return noise;
  }

  private void write(byte[] message, Socket socket) throws IOException {
    int at = 0;
    for (; manner == Manner.SLOW && at < Math.min(message.length, MAX_SLOW_BYTES); at++) {
      socket.getOutputStream().write(message, at, 1);
      if (random.nextInt(8) == 0) {
        LockSupport.parkNanos(TimeUnit.MICROSECONDS.toNanos(random.nextInt(2000)));
      }
    }
    socket.getOutputStream().write(message, at, message.length - at);
  }

  /** The number that the port has given to this session; empty if it gives none. */
  private byte[] sessionNumber(Socket socket) throws IOException {
    socket.setSoTimeout(GLANCE_MS);
    try {
      byte[] answer = socket.getInputStream().readNBytes(8);
      return answer.length == 8 ? Arrays.copyOfRange(answer, 4, 8) : new byte[0];
    } catch (SocketTimeoutException e) {
      return new byte[0];
    }
  }

  private void glance(Socket socket) throws IOException {
    socket.setSoTimeout(GLANCE_MS);
    try {
      var _ = socket.getInputStream().read(rubbish);
    } catch (SocketTimeoutException e) {
      // nothing has come, which is right at many ports
      return;
    }
  }

  private void leave(Socket socket) throws IOException {
    switch (leaving) {
      case HALF_CLOSED -> {
        socket.shutdownOutput();
        socket.setSoTimeout(PATIENCE_MS);
        InputStream input = socket.getInputStream();
        while (input.read(rubbish) >= 0) {
          // until the port has understood that nothing more comes
        }
      }
      case RESET -> socket.setSoLinger(true, 0);
      case CLOSED, DEAF -> {}
    }
  }
}
