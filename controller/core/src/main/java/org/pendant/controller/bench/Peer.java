package org.pendant.controller.bench;

import static org.pendant.controller.bench.BenchTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Peer: a computer that programs under test connect to by a socket, played by their test. It lives
 * in robot time; nothing of it is a real connection.
 */
public final class Peer {
  /** Bytes from programs that are kept until the test takes them; older ones go. */
  private static final int MAX_KEPT = 1 << 20;

  private final TestPeers peers;
  private final int port;
  private final StringBuilder inbox = new StringBuilder();
  private final List<PeerSocket> sockets = new ArrayList<>();
  private boolean refuses;
  private long delayFrames;

  Peer(TestPeers peers, int port) {
    this.peers = peers;
    this.port = port;
  }

  /** A program connects. */
  PeerSocket connect() {
    PeerSocket socket = new PeerSocket(this);
    sockets.removeIf(each -> each.stage() != PeerSocket.Stage.OPEN);
    sockets.add(socket);
    return socket;
  }

  boolean refuses() {
    return refuses;
  }

  String refusal() {
    return text("peerRefuses", port);
  }

  long frame() {
    return peers.frame();
  }

  long delayFrames() {
    return delayFrames;
  }

  /** Bytes from a program have come. */
  void take(byte[] bytes) {
    inbox.append(new String(bytes, StandardCharsets.ISO_8859_1));
    if (inbox.length() > MAX_KEPT) {
      inbox.delete(0, inbox.length() - MAX_KEPT);
    }
  }

  /** Has connections refused from now on, or accepted as at first. */
  public void setRefuses(boolean refuse) {
    refuses = refuse;
  }

  /** Has bytes of both ways arrive so many frames later, 0 or more. */
  public void setDelayFrames(long frames) {
    delayFrames = frames;
  }

  /** Whether a program is connected. */
  public boolean connected() {
    return sockets.stream().anyMatch(each -> each.stage() == PeerSocket.Stage.OPEN);
  }

  /**
   * Sends to every program that is connected.
   *
   * @param bytes one {@code char} a byte
   * @return whether there is one
   */
  public boolean send(String bytes) {
    byte[] raw = bytes.getBytes(StandardCharsets.ISO_8859_1);
    boolean sent = connected();
    sockets.forEach(each -> each.deliver(raw));
    return sent;
  }

  /** Ends all connections. */
  public void hangUp() {
    sockets.forEach(PeerSocket::hangUp);
  }

  /** What programs have sent and the test has not taken, one {@code char} a byte. */
  public String received() {
    return inbox.toString();
  }

  /** Takes the first bytes of {@link #received} away. */
  public void skip(int count) {
    inbox.delete(0, count);
  }

  void step() {
    sockets.forEach(PeerSocket::step);
  }
}
