package org.pendant.protocols.primary;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.pendant.protocols.wire.Dissector;

/** Robot message decoder: what {@link RobotMessageCodec} writes, and real robots. */
final class RobotMessageDecoder {
  /** A popup, as some versions of real robots tell it. */
  private static final byte POPUP = 2;

  /** Bytes in front of a title: what the popup wants, whether it warns, and so on. */
  private static final int POPUP_FLAGS = 4;

  private RobotMessageDecoder() {}

  /**
   * Reads a message.
   *
   * @param body what stands behind size and type of the package
   * @return empty for messages that say nothing to clients which run programs
   * @throws RuntimeException if it is cut off
   */
  static Optional<RobotMessage> decode(ByteBuffer body) {
    long timeUs = body.getLong();
    body.get(); // the source
    return switch (body.get()) {
      case RobotMessageCodec.VERSION -> Optional.of(new RobotMessage.Version());
      case RobotMessageCodec.TEXT ->
          Optional.of(new RobotMessage.Text(timeUs, Dissector.text(body)));
      case POPUP -> {
        long id = Integer.toUnsignedLong(body.getInt());
        body.position(body.position() + POPUP_FLAGS);
        String title = titled(body);
        yield Optional.of(
            new RobotMessage.Request(
                timeUs,
                id,
                RobotMessage.Wanted.NOTHING,
                title.isEmpty() ? Dissector.text(body) : title + ": " + Dissector.text(body)));
      }
      case RobotMessageCodec.ERROR_CODE -> {
        int code = body.getInt();
        int argument = body.getInt();
        int level = body.getInt();
        String text = Dissector.text(body.position(body.position() + 2 * Integer.BYTES));
        yield Optional.of(new RobotMessage.ErrorCode(timeUs, code, argument, level(level), text));
      }
      case RobotMessageCodec.KEY -> {
        body.position(body.position() + 2 * Integer.BYTES);
        String title = titled(body);
        yield Optional.of(new RobotMessage.Key(timeUs, title, Dissector.text(body)));
      }
      case RobotMessageCodec.REQUEST_VALUE -> {
        long id = Integer.toUnsignedLong(body.getInt());
        int wanted = body.get();
        yield Optional.of(
            new RobotMessage.Request(timeUs, id, wanted(wanted), Dissector.text(body)));
      }
      case RobotMessageCodec.RUNTIME_EXCEPTION -> {
        int line = body.getInt();
        int column = body.getInt();
        yield Optional.of(
            new RobotMessage.RuntimeFault(timeUs, line, column, Dissector.text(body)));
      }
      default -> Optional.empty();
    };
  }

  /** A text behind its length. */
  private static String titled(ByteBuffer body) {
    int length = Byte.toUnsignedInt(body.get());
    String title = Dissector.text(body.slice(body.position(), length));
    body.position(body.position() + length);
    return title;
  }

  private static RobotMessage.Level level(int number) {
    for (RobotMessage.Level each : RobotMessage.Level.values()) {
      if (each.number() == number) {
        return each;
      }
    }
    return number > RobotMessage.Level.VIOLATION.number()
        ? RobotMessage.Level.VIOLATION
        : RobotMessage.Level.INFO;
  }

  private static RobotMessage.Wanted wanted(int number) {
    for (RobotMessage.Wanted each : RobotMessage.Wanted.values()) {
      if (each.number() == number) {
        return each;
      }
    }
    return RobotMessage.Wanted.STRING;
  }
}
