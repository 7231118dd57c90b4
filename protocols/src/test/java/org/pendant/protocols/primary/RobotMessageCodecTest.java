package org.pendant.protocols.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.pendant.controller.state.SoftwareVersion;

class RobotMessageCodecTest {
  private static final long TIME_US = 12_345_678_000L;

  /** Expected bytes: hexadecimal digits, with texts in double quotes and blanks between. */
  static String hex(String notation) {
    StringBuilder hex = new StringBuilder();
    String[] parts = notation.split("\"", -1);
    for (int i = 0; i < parts.length; i++) {
      hex.append(
          i % 2 == 0
              ? parts[i].replace(" ", "")
              : HexFormat.of().formatHex(parts[i].getBytes(StandardCharsets.ISO_8859_1)));
    }
    return hex.toString().toLowerCase(Locale.ROOT);
  }

  private static void assertBytes(String notation, RobotMessage message) {
    byte[] bytes = RobotMessageCodec.encode(message);
    assertEquals(hex(notation), HexFormat.of().formatHex(bytes));
    assertEquals(bytes.length, ByteBuffer.wrap(bytes).getInt());
  }

  @Test
  void version() {
    String numbers =
        HexFormat.of().toHexDigits((byte) SoftwareVersion.REPORTED.major())
            + HexFormat.of().toHexDigits((byte) SoftwareVersion.REPORTED.minor())
            + HexFormat.of().toHexDigits(SoftwareVersion.REPORTED.bugfix())
            + HexFormat.of().toHexDigits(SoftwareVersion.REPORTED.build());
    assertBytes(
        "00000037 14 FFFFFFFFFFFFFFFF FE 03 09 \"URControl\""
            + numbers
            + "\"01-10-2025, 00:00:00\"",
        new RobotMessage.Version());
  }

  @Test
  void secondMessageOfAConnection() {
    assertBytes(
        "00000018 14 FFFFFFFFFFFFFFFF FE 0C 00000000 00000000 01", new RobotMessage.Second());
  }

  @Test
  void text() {
    assertBytes(
        "00000014 14 00000002DFDC18B0 FD 00 \"hello\"", new RobotMessage.Text(TIME_US, "hello"));
  }

  @Test
  void key() {
    assertBytes(
        "0000002F 14 00000002DFDC18B0 FD 07 00000000 00000000 13 \"PROGRAM_XXX_STARTED\" \"prog\"",
        new RobotMessage.Key(TIME_US, "PROGRAM_XXX_STARTED", "prog"));
  }

  @Test
  void exception() {
    assertBytes(
        "00000032 14 00000002DFDC18B0 FD 0A 00000002 00000001 \"syntax_error_on_line:2:end:\"",
        new RobotMessage.RuntimeFault(TIME_US, 2, 1, "syntax_error_on_line:2:end:"));
  }

  @Test
  void errorCode() {
    assertBytes(
        "00000023 14 00000002DFDC18B0 FD 06 00000099 00000002 00000003 00000000 00000000",
        new RobotMessage.ErrorCode(TIME_US, 153, 2, RobotMessage.Level.VIOLATION, ""));
  }

  @Test
  void safetyMode() {
    assertBytes(
        "00000020 14 00000002DFDC18B0 FD 05 00000000 00000000 03 00000000 00000000",
        new RobotMessage.Safety(TIME_US, 3));
  }

  @Test
  void request() {
    assertBytes(
        "0000001B 14 00000002DFDC18B0 FD 09 00000001 02 \"Offset?\"",
        new RobotMessage.Request(TIME_US, 1, RobotMessage.Wanted.FLOAT, "Offset?"));
  }

  @Test
  void labels() {
    assertBytes(
        "00000023 14 00000002DFDC18B0 FD 0E 00000002 00000005 \"MoveJ\" 00000003 \"job\"",
        new RobotMessage.Labels(TIME_US, 2, "MoveJ", "job"));
  }

  @Test
  void aLongTextIsCut() {
    byte[] bytes = RobotMessageCodec.encode(new RobotMessage.Text(TIME_US, "x".repeat(100_000)));
    assertEquals(15 + RobotMessageCodec.MAX_TEXT, bytes.length);
    assertEquals(bytes.length, ByteBuffer.wrap(bytes).getInt());
  }
}
