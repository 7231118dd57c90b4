package org.pendant.controller.bench;

import java.util.ArrayDeque;
import java.util.Deque;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.controller.external.ReceivedBytes;

/** Peer socket: a connection of a program to a {@link Peer} of its test. */
final class PeerSocket implements ExternalSocket {
  /** Bytes on their way that are kept; what is more is lost, as where a peer reads nothing. */
  private static final int MAX_UNDER_WAY = 1 << 20;

  /** Bytes that arrive in a frame. */
  private static final class Due {
    private final long frame;
    private final byte[] bytes;

    Due(long frame, byte[] bytes) {
      this.frame = frame;
      this.bytes = bytes;
    }
  }

  private final Peer peer;
  private final ReceivedBytes received = new ReceivedBytes();
  private final Deque<Due> toProgram = new ArrayDeque<>();
  private final Deque<Due> toPeer = new ArrayDeque<>();
  private int underWay;
  private Stage stage;
  private boolean closing;

  PeerSocket(Peer peer) {
    this.peer = peer;
    stage = peer.refuses() ? Stage.FAILED : Stage.OPEN;
  }

  @Override
  public Stage stage() {
    return stage;
  }

  @Override
  public String failure() {
    return stage == Stage.FAILED ? peer.refusal() : "";
  }

  @Override
  public boolean send(byte[] bytes) {
    if (stage != Stage.OPEN || underWay + bytes.length > MAX_UNDER_WAY) {
      return false;
    }
    if (peer.delayFrames() == 0) {
      peer.take(bytes);
    } else {
      underWay += bytes.length;
      toPeer.add(new Due(peer.frame() + peer.delayFrames(), bytes));
    }
    return true;
  }

  @Override
  public ReceivedBytes received() {
    return received;
  }

  @Override
  public void close() {
    if (stage == Stage.OPEN) {
      end();
    }
  }

  /** Sends to the program. */
  void deliver(byte[] bytes) {
    if (stage == Stage.OPEN && underWay + bytes.length <= MAX_UNDER_WAY) {
      underWay += bytes.length;
      toProgram.add(new Due(peer.frame() + peer.delayFrames(), bytes));
      step();
    }
  }

  /** Ends the connection after what is on its way to the program. */
  void hangUp() {
    closing = true;
    step();
  }

  private void end() {
    stage = Stage.CLOSED;
    received.end();
  }

  /** Moves what is due; as much as there is room for. */
  void step() {
    while (!toPeer.isEmpty() && toPeer.peek().frame <= peer.frame()) {
      byte[] bytes = toPeer.poll().bytes;
      underWay -= bytes.length;
      peer.take(bytes);
    }
    while (!toProgram.isEmpty()
        && toProgram.peek().frame <= peer.frame()
        && hasRoom(toProgram.peek().bytes.length)) {
      byte[] bytes = toProgram.poll().bytes;
      underWay -= bytes.length;
      append(bytes);
    }
    if (closing && toProgram.isEmpty() && stage == Stage.OPEN) {
      end();
    }
  }

  private boolean hasRoom(int count) {
    return ReceivedBytes.CAPACITY - received.length() >= Math.min(count, ReceivedBytes.CAPACITY);
  }

  private void append(byte[] bytes) {
    try {
      received.append(bytes, Math.min(bytes.length, ReceivedBytes.CAPACITY));
    } catch (InterruptedException e) {
      // there is room, so that it does not wait
      Thread.currentThread().interrupt();
    }
  }
}
