package org.pendant.protocols.primary;

import java.nio.ByteBuffer;
import java.util.Map;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Fields;
import org.pendant.protocols.wire.Reading;

/** Robot message reading: what {@link RobotMessageCodec} has written, for people. */
final class RobotMessageReading {
  private RobotMessageReading() {}

  /**
   * Reads a message.
   *
   * @param body what stands behind size and type
   */
  static Reading of(ByteBuffer body) {
    long timeUs = body.getLong();
    body.get(); // the source
    byte type = body.get();
    return switch (type) {
      case RobotMessageCodec.VERSION -> version(body);
      case RobotMessageCodec.TEXT -> quoted("text", timeUs, Dissector.text(body));
      case RobotMessageCodec.SAFETY_MODE -> {
        int mode = body.position(body.position() + 8).get();
        yield Reading.of(
            "safety-mode",
            PrimaryTexts.text("safetyMode", RobotStateReading.safetyMode(mode)),
            () -> Fields.of("time_us", timeUs, "safety_mode", mode));
      }
      case RobotMessageCodec.ERROR_CODE -> error(timeUs, body);
      case RobotMessageCodec.KEY -> {
        int length = Byte.toUnsignedInt(body.position(body.position() + 8).get());
        String title = Dissector.text(body.slice(body.position(), length));
        String text = Dissector.text(body.position(body.position() + length));
        yield quoted("key-message", timeUs, title + ": " + text);
      }
      case RobotMessageCodec.REQUEST_VALUE -> {
        int number = body.getInt();
        body.get(); // what is wanted
        yield text("request", timeUs, PrimaryTexts.text("asks", number, Dissector.text(body)));
      }
      case RobotMessageCodec.RUNTIME_EXCEPTION -> {
        int line = body.getInt();
        int column = body.getInt();
        yield quoted(
            "runtime-exception", timeUs, line + ":" + column + ": " + Dissector.text(body));
      }
      case RobotMessageCodec.LABELS -> {
        int number = body.getInt();
        int length = body.getInt();
        String label = Dissector.text(body.slice(body.position(), length));
        yield text("label", timeUs, PrimaryTexts.text("node", number, label));
      }
      default ->
          Reading.of(
              "message",
              PrimaryTexts.text("messageOfType", type),
              () -> Fields.of("time_us", timeUs));
    };
  }

  private static Reading text(String type, long timeUs, String text) {
    return Reading.of(type, text, () -> Fields.of("time_us", timeUs, "text", text));
  }

  private static Reading quoted(String type, long timeUs, String text) {
    return Reading.quoting(type, text, () -> Fields.of("time_us", timeUs, "text", text));
  }

  private static Reading version(ByteBuffer body) {
    int length = Byte.toUnsignedInt(body.get());
    String name = Dissector.text(body.slice(body.position(), length));
    body.position(body.position() + length);
    String version = body.get() + "." + body.get() + "." + body.getInt() + "." + body.getInt();
    return Reading.quoting(
        "version", name + " " + version, () -> Fields.of("name", name, "version", version));
  }

  private static Reading error(long timeUs, ByteBuffer body) {
    int code = body.getInt();
    int argument = body.getInt();
    int level = body.getInt();
    String text = Dissector.text(body.position(body.position() + 8));
    return Reading.quoting(
        "error-code",
        "C" + code + "A" + argument + ": " + text,
        () -> {
          Map<String, Object> fields = Fields.of("time_us", timeUs, "text", text);
          fields.put("code", code);
          fields.put("argument", argument);
          fields.put("level", level);
          return fields;
        });
  }
}
