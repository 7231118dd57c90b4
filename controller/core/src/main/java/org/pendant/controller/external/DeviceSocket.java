package org.pendant.controller.external;

import java.nio.charset.StandardCharsets;

/**
 * Device socket: a connection of a program to a device in robot time. What a program sends in one
 * frame the device hears at the beginning of the next, and its answer is there at once.
 */
public final class DeviceSocket implements ExternalSocket {
  /** Bytes of one frame that are taken; a program that sends more is told that it was too much. */
  private static final int MAX_INBOX = 1 << 16;

  private final DeviceTalk talk;
  private final ReceivedBytes received = new ReceivedBytes();
  private final StringBuilder inbox = new StringBuilder();
  private boolean open = true;

  /** An open connection to who holds {@code talk}. */
  public DeviceSocket(DeviceTalk talk) {
    this.talk = talk;
  }

  @Override
  public Stage stage() {
    return open ? Stage.OPEN : Stage.CLOSED;
  }

  @Override
  public String failure() {
    return "";
  }

  @Override
  public boolean send(byte[] bytes) {
    if (!open || inbox.length() + bytes.length > MAX_INBOX) {
      return false;
    }
    inbox.append(new String(bytes, StandardCharsets.ISO_8859_1));
    return true;
  }

  @Override
  public ReceivedBytes received() {
    return received;
  }

  @Override
  public void close() {
    open = false;
    received.end();
  }

  @Override
  public boolean inRobotTime() {
    return true;
  }

  /**
   * Has the device hear what was sent, once a frame.
   *
   * @return whether the connection goes on; one that was closed is heard to its end
   */
  public boolean step() {
    String heard = "";
    if (!inbox.isEmpty()) {
      heard = inbox.toString();
      inbox.setLength(0);
    }
    String answer = talk.hear(heard);
    if (open && !answer.isEmpty()) {
      deliver(answer.getBytes(StandardCharsets.ISO_8859_1));
    }
    return open;
  }

  /** A program that reads nothing loses what there is no room for. */
  private void deliver(byte[] bytes) {
    int room = ReceivedBytes.CAPACITY - received.length();
    try {
      received.append(bytes, Math.min(bytes.length, room));
    } catch (InterruptedException e) {
      // there is room, so that it does not wait
      Thread.currentThread().interrupt();
    }
  }
}
