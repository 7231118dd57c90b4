package org.pendant.controller.external;

/** Device talk: the device's side of one connection. */
@FunctionalInterface
public interface DeviceTalk {
  /**
   * Hears what has arrived since the frame before, and says what it answers.
   *
   * @param bytes one {@code char} a byte; mostly empty, as this is called once a frame
   * @return one {@code char} a byte; empty for nothing
   */
  String hear(String bytes);
}
