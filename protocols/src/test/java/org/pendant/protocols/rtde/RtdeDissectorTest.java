package org.pendant.protocols.rtde;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.rtde.FieldType;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Reading;

class RtdeDissectorTest {
  private final Dissector dissector = RtdeTerms.NONE.dissector();

  private static ByteBuffer packet(char type, ByteBuffer payload) {
    int size = 3 + payload.remaining();
    return ByteBuffer.allocate(size).putShort((short) size).put((byte) type).put(payload).flip();
  }

  private static ByteBuffer bytes(int... bytes) {
    ByteBuffer buffer = ByteBuffer.allocate(bytes.length);
    for (int each : bytes) {
      buffer.put((byte) each);
    }
    return buffer.flip();
  }

  private static ByteBuffer text(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  private Reading in(char type, ByteBuffer payload) {
    return dissector.read(Direction.IN, packet(type, payload));
  }

  private Reading out(char type, ByteBuffer payload) {
    return dissector.read(Direction.OUT, packet(type, payload));
  }

  private void speak2() {
    in('V', bytes(0, 2));
    out('V', bytes(1));
  }

  private static ByteBuffer outputs(double frequencyHz, String names) {
    return ByteBuffer.allocate(8 + names.length()).putDouble(frequencyHz).put(text(names)).flip();
  }

  @Test
  void readsDataByTheNamesOfTheRecipe() {
    speak2();
    Reading wanted = in('O', outputs(125, "timestamp,robot_mode"));
    assertEquals("wants at 125 Hz: timestamp, robot_mode", wanted.summary());
    out('O', text("\u0001DOUBLE,INT32"));
    Reading data = out('U', ByteBuffer.allocate(13).put((byte) 1).putDouble(2.5).putInt(7).flip());
    assertEquals("timestamp = 2.5, 1 more", data.summary());
    assertEquals(
        Map.of("recipe", 1, "values", Map.of("timestamp", 2.5, "robot_mode", 7L)),
        data.fields().get());
  }

  @Test
  void tellsWhichRegistersAPackageChanges() {
    speak2();
    in('I', text("input_int_register_0,input_int_register_1"));
    out('I', text("\u0001INT32,INT32"));
    ByteBuffer first = bytes(1, 0, 0, 0, 5, 0, 0, 0, 6);
    assertEquals(
        Optional.of("sets input_int_register_0 = 5, input_int_register_1 = 6"),
        in('U', first.duplicate()).effect());
    assertEquals(Optional.empty(), in('U', first.duplicate()).effect());
    assertEquals(
        Optional.of("sets input_int_register_1 = 7"),
        in('U', bytes(1, 0, 0, 0, 5, 0, 0, 0, 7)).effect());
  }

  @Test
  void saysWhichVariablesAreRefused() {
    speak2();
    in('O', outputs(500, "timestamp,nonsense"));
    assertEquals(
        "refused: nonsense is NOT_FOUND", out('O', text("\u0000DOUBLE,NOT_FOUND")).summary());
  }

  @Test
  void goesOnFromWhatWasAgreedOnBefore() {
    RtdeTerms terms =
        RtdeTerms.NONE
            .withVersion(2)
            .withOutputs(List.of(new ReceivedField("timestamp", FieldType.DOUBLE)), 500);
    Reading data =
        terms
            .dissector()
            .read(
                Direction.OUT,
                packet('U', ByteBuffer.allocate(9).put((byte) 1).putDouble(1).flip()));
    assertEquals("timestamp = 1.0", data.summary());
  }

  @Test
  void readsTextsOfBothVersions() {
    assertEquals(
        "says: hm",
        out('M', ByteBuffer.allocate(3).put((byte) 1).put(text("hm")).flip()).summary());
    speak2();
    ByteBuffer reply =
        ByteBuffer.wrap(ReplyCodec.text(TextLevel.ERROR, "no", 2)).position(3).slice();
    assertEquals("says: RTDE: no", out('M', reply).summary());
  }

  @Test
  void takesItsLengthFromTheFirstTwoBytes() {
    assertEquals(Dissector.MORE, dissector.length(Direction.IN, bytes(0)));
    assertEquals(300, dissector.length(Direction.IN, bytes(1, 44)));
    assertEquals(Dissector.UNKNOWN, dissector.length(Direction.IN, bytes(0, 2)));
  }
}
