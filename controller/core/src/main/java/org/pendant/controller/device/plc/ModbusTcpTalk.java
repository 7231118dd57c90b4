package org.pendant.controller.device.plc;

import org.pendant.controller.external.DeviceTalk;

/**
 * Modbus TCP talk: the device's side of a connection (Modbus Messaging on TCP/IP V1.0b, 3.1). What
 * is no Modbus is dropped, with all that came with it.
 */
final class ModbusTcpTalk implements DeviceTalk {
  private static final int HEAD = 6;
  private static final int MAX_LENGTH = 254;

  private final Requests requests;
  private final StringBuilder received = new StringBuilder();

  /** Who answers requests. */
  @FunctionalInterface
  interface Requests {
    /**
     * Answers a request, one {@code char} a byte.
     *
     * @return empty for no answer at all
     */
    String answer(int unit, String request);
  }

  ModbusTcpTalk(Requests requests) {
    this.requests = requests;
  }

  @Override
  public String hear(String bytes) {
    received.append(bytes);
    StringBuilder answers = new StringBuilder();
    while (received.length() >= HEAD) {
      int length = word(HEAD - 2);
      if (word(2) != 0 || length < 2 || length > MAX_LENGTH) {
        received.setLength(0);
        break;
      }
      if (received.length() < HEAD + length) {
        break;
      }
      String answer =
          requests.answer(received.charAt(HEAD), received.substring(HEAD + 1, HEAD + length));
      if (!answer.isEmpty()) {
        answers
            .append(received, 0, HEAD - 2)
            .append((char) ((answer.length() + 1) >> Byte.SIZE))
            .append((char) (answer.length() + 1 & 0xFF))
            .append(received.charAt(HEAD))
            .append(answer);
      }
      received.delete(0, HEAD + length);
    }
    return answers.toString();
  }

  private int word(int at) {
    return received.charAt(at) << Byte.SIZE | received.charAt(at + 1);
  }
}
