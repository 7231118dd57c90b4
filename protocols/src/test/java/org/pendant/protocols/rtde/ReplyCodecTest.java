package org.pendant.protocols.rtde;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.state.SoftwareVersion;

class ReplyCodecTest {
  private static String hex(byte[] bytes) {
    return HexFormat.of().formatHex(bytes);
  }

  @Test
  void saysYesAndNo() {
    assertEquals("00045601", hex(ReplyCodec.accepted(PacketType.PROTOCOL_VERSION, true)));
    assertEquals("00045300", hex(ReplyCodec.accepted(PacketType.START, false)));
  }

  @Test
  void saysWhichSoftwareItIs() {
    assertEquals(
        "00137600000005000000180000000000" + "12c4b0",
        hex(ReplyCodec.controllerVersion(new SoftwareVersion(5, 24, 0, 1_230_000, ""))));
  }

  @Test
  void answersRecipesWithTheirTypes() {
    assertEquals(
        "00134f01444f55424c452c564543544f523644",
        hex(ReplyCodec.recipe(PacketType.SETUP_OUTPUTS, 1, List.of("DOUBLE", "VECTOR6D"))));
    assertEquals(
        "00094f444f55424c45", hex(ReplyCodec.recipe(PacketType.SETUP_OUTPUTS, List.of("DOUBLE"))));
  }

  @Test
  void textsHaveTheShapeOfTheVersion() {
    assertEquals(
        "000f4d0548656c6c6f045254444503", hex(ReplyCodec.text(TextLevel.INFO, "Hello", 2)));
    assertEquals("00094d0348656c6c6f", hex(ReplyCodec.text(TextLevel.INFO, "Hello", 1)));
  }

  @Test
  void aTextThatIsTooLongLosesItsEnd() {
    byte[] packet = ReplyCodec.text(TextLevel.ERROR, "x".repeat(300), 2);
    assertEquals(3 + 1 + 255 + 1 + 4 + 1, packet.length);
    assertEquals((byte) 255, packet[3]);
  }
}
