package org.pendant.protocols.primary;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.pendant.controller.state.SoftwareVersion;

/**
 * Robot message codec: robot messages as bytes, big-endian: {@code i32 size, u8 20, u64 time, i8
 * source, i8 type}.
 */
final class RobotMessageCodec {
  private static final int HEADER = 15;
  private static final byte ROBOT_MESSAGE = 20;
  private static final byte ROBOT_INTERFACE = -2;
  private static final byte REALTIME_MACHINE = -3;

  static final byte TEXT = 0;
  static final byte VERSION = 3;
  static final byte SAFETY_MODE = 5;
  static final byte ERROR_CODE = 6;
  static final byte KEY = 7;
  static final byte REQUEST_VALUE = 9;
  static final byte RUNTIME_EXCEPTION = 10;
  static final byte SECOND = 12;
  static final byte LABELS = 14;

  /** Stands in front of a value that is not there. */
  private static final int NO_DATA = 0;

  private static final String PRODUCT = "URControl";
  private static final String BUILD_DATE = "01-10-2025, 00:00:00";

  /** Bytes of a text that are sent; what a program writes may be longer. */
  static final int MAX_TEXT = 1 << 15;

  private static final int MAX_TITLE = 255;

  private RobotMessageCodec() {}

  static byte[] encode(RobotMessage message) {
    return switch (message) {
      case RobotMessage.Version version -> version();
      case RobotMessage.Second second ->
          begin(RobotMessage.BEFORE, ROBOT_INTERFACE, SECOND, 9)
              .putInt(0)
              .putInt(0)
              .put((byte) 1)
              .array();
      case RobotMessage.Text text -> {
        byte[] bytes = bytes(text.text(), MAX_TEXT);
        yield begin(text.timeUs(), REALTIME_MACHINE, TEXT, bytes.length).put(bytes).array();
      }
      case RobotMessage.Safety safety ->
          begin(safety.timeUs(), REALTIME_MACHINE, SAFETY_MODE, 17)
              .putInt(0)
              .putInt(0)
              .put((byte) safety.mode())
              .putInt(NO_DATA)
              .putInt(0)
              .array();
      case RobotMessage.ErrorCode error -> {
        byte[] bytes = bytes(error.text(), MAX_TEXT);
        yield begin(error.timeUs(), REALTIME_MACHINE, ERROR_CODE, 20 + bytes.length)
            .putInt(error.code())
            .putInt(error.argument())
            .putInt(error.level().number())
            .putInt(NO_DATA)
            .putInt(0)
            .put(bytes)
            .array();
      }
      case RobotMessage.Key key -> {
        byte[] title = bytes(key.title(), MAX_TITLE);
        byte[] bytes = bytes(key.text(), MAX_TEXT);
        yield begin(key.timeUs(), REALTIME_MACHINE, KEY, 9 + title.length + bytes.length)
            .putInt(0)
            .putInt(0)
            .put((byte) title.length)
            .put(title)
            .put(bytes)
            .array();
      }
      case RobotMessage.Request request -> {
        byte[] bytes = bytes(request.text(), MAX_TEXT);
        yield begin(request.timeUs(), REALTIME_MACHINE, REQUEST_VALUE, 5 + bytes.length)
            .putInt((int) request.id())
            .put((byte) request.wanted().number())
            .put(bytes)
            .array();
      }
      case RobotMessage.RuntimeFault exception -> {
        byte[] bytes = bytes(exception.text(), MAX_TEXT);
        yield begin(exception.timeUs(), REALTIME_MACHINE, RUNTIME_EXCEPTION, 8 + bytes.length)
            .putInt(exception.line())
            .putInt(exception.column())
            .put(bytes)
            .array();
      }
      case RobotMessage.Labels labels -> {
        byte[] text = bytes(labels.text(), MAX_TEXT);
        byte[] thread = bytes(labels.thread(), MAX_TEXT);
        yield begin(labels.timeUs(), REALTIME_MACHINE, LABELS, 12 + text.length + thread.length)
            .putInt(labels.number())
            .putInt(text.length)
            .put(text)
            .putInt(thread.length)
            .put(thread)
            .array();
      }
    };
  }

  private static byte[] version() {
    byte[] name = bytes(PRODUCT, MAX_TITLE);
    byte[] date = bytes(BUILD_DATE, MAX_TITLE);
    return begin(RobotMessage.BEFORE, ROBOT_INTERFACE, VERSION, 11 + name.length + date.length)
        .put((byte) name.length)
        .put(name)
        .put((byte) SoftwareVersion.REPORTED.major())
        .put((byte) SoftwareVersion.REPORTED.minor())
        .putInt(SoftwareVersion.REPORTED.bugfix())
        .putInt(SoftwareVersion.REPORTED.build())
        .put(date)
        .array();
  }

  private static ByteBuffer begin(long timeUs, byte source, byte type, int bodyBytes) {
    return ByteBuffer.allocate(HEADER + bodyBytes)
        .putInt(HEADER + bodyBytes)
        .put(ROBOT_MESSAGE)
        .putLong(timeUs)
        .put(source)
        .put(type);
  }

  private static byte[] bytes(String text, int most) {
    String sent = text.length() > most ? text.substring(0, most) : text;
    return sent.getBytes(StandardCharsets.ISO_8859_1);
  }
}
