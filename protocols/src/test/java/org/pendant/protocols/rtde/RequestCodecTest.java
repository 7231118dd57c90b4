package org.pendant.protocols.rtde;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.net.ProtocolException;

class RequestCodecTest {
  private static final HexFormat HEX = HexFormat.of();

  /** Some of everything, one behind the other. */
  private static final byte[] CONVERSATION =
      bytes(
          "0005560002"
              + "000376"
              + "001d4f405f400000000000"
              + text("timestamp,actual_q")
              + "002a49"
              + text("speed_slider_mask,speed_slider_fraction")
              + "000353"
              + "00105501000000013fe0000000000000"
              + "000f4d05"
              + text("Hello")
              + "04"
              + text("RTDE")
              + "03"
              + "000350");

  private static byte[] bytes(String hex) {
    return HEX.parseHex(hex);
  }

  private static String text(String text) {
    return HEX.formatHex(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  private static RtdeRequest decode(int type, String payloadHex, int version) {
    return RequestCodec.decode(new Packet(type, ByteBuffer.wrap(bytes(payloadHex))), version);
  }

  private static List<String> shown(List<Packet> packets) {
    return packets.stream()
        .map(each -> RequestCodec.decode(each, 2))
        .map(Object::toString)
        .toList();
  }

  private static List<Packet> cut(PacketCutter cutter, byte[] bytes, int from, int to)
      throws ProtocolException {
    ByteBuffer some = ByteBuffer.wrap(bytes, from, to - from);
    List<Packet> packets = new ArrayList<>();
    for (Optional<Packet> next = cutter.next(some); next.isPresent(); next = cutter.next(some)) {
      packets.add(next.get());
    }
    return packets;
  }

  @Test
  void understandsAConversation() throws ProtocolException {
    assertEquals(
        List.of(
            new RtdeRequest.ProtocolVersion(2).toString(),
            new RtdeRequest.ControllerVersion().toString(),
            new RtdeRequest.SetupOutputs(125, List.of("timestamp", "actual_q")).toString(),
            new RtdeRequest.SetupInputs(List.of("speed_slider_mask", "speed_slider_fraction"))
                .toString(),
            new RtdeRequest.Start().toString(),
            "Data[recipe=1, values=java.nio.HeapByteBuffer[pos=1 lim=13 cap=13]]",
            new RtdeRequest.Text(TextLevel.INFO, "RTDE: Hello").toString(),
            new RtdeRequest.Pause().toString()),
        shown(cut(new PacketCutter(), CONVERSATION, 0, CONVERSATION.length)));
  }

  @Test
  void packagesMayBeCutAnywhere() throws ProtocolException {
    List<String> whole = shown(cut(new PacketCutter(), CONVERSATION, 0, CONVERSATION.length));
    for (int at = 0; at <= CONVERSATION.length; at++) {
      PacketCutter cutter = new PacketCutter();
      List<Packet> packets = cut(cutter, CONVERSATION, 0, at);
      packets.addAll(cut(cutter, CONVERSATION, at, CONVERSATION.length));
      assertEquals(whole, shown(packets), "cut at " + at);
    }
    PacketCutter cutter = new PacketCutter();
    List<Packet> packets = new ArrayList<>();
    for (int at = 0; at < CONVERSATION.length; at++) {
      packets.addAll(cut(cutter, CONVERSATION, at, at + 1));
    }
    assertEquals(whole, shown(packets));
  }

  @Test
  void aSizeThatDoesNotCountItselfEndsTheConnection() {
    for (String size : List.of("0000", "0001", "0002")) {
      byte[] header = bytes(size + "56");
      assertThrows(ProtocolException.class, () -> cut(new PacketCutter(), header, 0, 3));
    }
  }

  @Test
  void theLongestPackageIsCutLikeAnyOther() throws ProtocolException {
    byte[] longest = new byte[0xFFFF];
    longest[0] = (byte) 0xFF;
    longest[1] = (byte) 0xFF;
    longest[2] = 'I';
    List<Packet> packets = cut(new PacketCutter(), longest, 0, longest.length);
    assertEquals(1, packets.size());
    assertEquals(
        new RtdeRequest.RefusedSetup(
            'I', "the names of a recipe take 65532 bytes, must be at most 16384"),
        RequestCodec.decode(packets.getFirst(), 2));
  }

  @Test
  void namesTakeAtMost16384Bytes() {
    assertInstanceOf(RtdeRequest.SetupInputs.class, decode('I', "61".repeat(16_384), 2));
    assertInstanceOf(RtdeRequest.RefusedSetup.class, decode('I', "61".repeat(16_385), 2));
    assertInstanceOf(
        RtdeRequest.SetupOutputs.class, decode('O', "405f400000000000" + "61".repeat(16_384), 2));
    assertInstanceOf(
        RtdeRequest.RefusedSetup.class, decode('O', "405f400000000000" + "61".repeat(16_385), 2));
  }

  @Test
  void aCommaBehindTheLastNameIsIgnored() {
    assertEquals(new RtdeRequest.SetupInputs(List.of("a", "b")), decode('I', text("a,b,"), 2));
    assertEquals(new RtdeRequest.SetupInputs(List.of("a", "", "b")), decode('I', text("a,,b"), 2));
    assertEquals(
        new RtdeRequest.SetupOutputs(500, List.of("a")),
        decode('O', "407f400000000000" + text("a,"), 2));
  }

  @Test
  void aRecipeNamesSomething() {
    RtdeRequest nothing = new RtdeRequest.Malformed(TextLevel.ERROR, "a recipe names no variable");
    assertEquals(nothing, decode('I', "", 2));
    assertEquals(nothing, decode('O', "407f400000000000", 2));
    assertEquals(nothing, decode('O', "", 1));
  }

  @Test
  void versionOneNamesNoFrequency() {
    assertEquals(
        new RtdeRequest.SetupOutputs(125, List.of("timestamp")), decode('O', text("timestamp"), 1));
    assertEquals(new RtdeRequest.Text(TextLevel.WARNING, "Hi"), decode('M', "02" + text("Hi"), 1));
  }

  @Test
  void wrongLengthsAreMalformed() {
    for (String payload : List.of("", "02", "000200")) {
      assertInstanceOf(RtdeRequest.Malformed.class, decode('V', payload, 1), payload);
    }
    for (int type : new int[] {'v', 'S', 'P'}) {
      assertInstanceOf(RtdeRequest.Malformed.class, decode(type, "00", 2));
    }
    assertInstanceOf(RtdeRequest.Malformed.class, decode('U', "", 2));
    assertInstanceOf(RtdeRequest.Malformed.class, decode('O', "405f4000000000", 2));
    assertInstanceOf(RtdeRequest.Malformed.class, decode('M', "", 1));
    assertInstanceOf(RtdeRequest.Malformed.class, decode('X', "", 2));
  }

  @Test
  void aTextMessageFitsItsLengths() {
    String whole = "05" + text("Hello") + "04" + text("RTDE") + "03";
    for (int bytes = 0; bytes < whole.length() / 2; bytes++) {
      assertInstanceOf(
          RtdeRequest.Malformed.class, decode('M', whole.substring(0, 2 * bytes), 2), "" + bytes);
    }
    assertInstanceOf(RtdeRequest.Malformed.class, decode('M', whole + "00", 2));
    assertEquals(new RtdeRequest.Text(TextLevel.INFO, ""), decode('M', "00" + "00" + "09", 2));
  }

  @Test
  void anyBytesAreUnderstoodOrRefused() {
    long seed = 20_260_705L;
    Random random = new Random(seed);
    for (int i = 0; i < 20_000; i++) {
      byte[] bytes = new byte[random.nextInt(80)];
      random.nextBytes(bytes);
      if (bytes.length > 2 && random.nextBoolean()) {
        bytes[0] = 0;
        bytes[1] = (byte) (3 + random.nextInt(bytes.length));
        bytes[2] = (byte) "VvOISPUM".charAt(random.nextInt(8));
      }
      String shown = "seed " + seed + ": " + HEX.formatHex(bytes);
      try {
        for (Packet packet : cut(new PacketCutter(), bytes, 0, bytes.length)) {
          for (int version = 1; version <= 2; version++) {
            Packet copy = new Packet(packet.type(), packet.payload().duplicate());
            assertTrue(RequestCodec.decode(copy, version).toString().length() > 0, shown);
          }
        }
      } catch (ProtocolException e) {
        assertTrue(e.getMessage().startsWith("the size of a package is"), shown);
      }
    }
  }
}
