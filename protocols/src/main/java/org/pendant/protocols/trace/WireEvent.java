package org.pendant.protocols.trace;

import java.nio.ByteBuffer;
import org.pendant.protocols.net.WireEnd;

/**
 * Wire event: something that has happened on a connection.
 *
 * @param before how many bytes had gone in the same direction before
 * @param bytes empty where none go; read-only
 * @param epochUs time of the computer, us since 1970
 * @param robotTimeS time of the robot, s
 */
record WireEvent(
    Kind kind, WireEnd connection, long before, ByteBuffer bytes, long epochUs, double robotTimeS) {

  /** What has happened. */
  enum Kind {
    OPENED,
    RECEIVED,
    SENT,
    CLOSED
  }
}
