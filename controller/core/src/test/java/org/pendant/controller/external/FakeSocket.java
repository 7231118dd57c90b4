package org.pendant.controller.external;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** A socket without a network: a test says what the peer does. */
public final class FakeSocket implements ExternalSocket {
  private final ByteArrayOutputStream sent = new ByteArrayOutputStream();
  private final ReceivedBytes received = new ReceivedBytes();
  private Stage stage = Stage.CONNECTING;
  private String failure = "";

  /** The peer takes the connection. */
  public void accept() {
    stage = Stage.OPEN;
  }

  /** The peer takes no connection. */
  public void refuse(String why) {
    failure = why;
    stage = Stage.FAILED;
  }

  /** The peer sends, one {@code char} a byte. */
  public void say(String bytes) {
    try {
      received.append(bytes.getBytes(StandardCharsets.ISO_8859_1), bytes.length());
    } catch (InterruptedException e) {
      throw new IllegalStateException("nobody interrupts a test", e);
    }
  }

  /** The peer sends no more. */
  public void endSending() {
    received.end();
  }

  /** The peer is gone. */
  public void reset() {
    stage = Stage.CLOSED;
    received.end();
  }

  /** What the script has sent. */
  public String heard() {
    return sent.toString(StandardCharsets.ISO_8859_1);
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
    if (stage == Stage.OPEN) {
      sent.writeBytes(bytes);
    }
    return stage == Stage.OPEN;
  }

  @Override
  public ReceivedBytes received() {
    return received;
  }

  @Override
  public void close() {
    stage = Stage.CLOSED;
    received.abandon();
  }
}
