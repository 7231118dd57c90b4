package org.pendant.protocols.modbus;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Reading;

class ModbusDissectorTest {
  private final ModbusDissector dissector = new ModbusDissector();

  private Reading read(Direction direction, String hex) {
    ByteBuffer bytes = ByteBuffer.wrap(Hex.bytes(hex));
    assertEquals(bytes.remaining(), dissector.length(direction, bytes));
    return dissector.read(direction, bytes);
  }

  @Test
  void readsAnEnquiryAndItsAnswer() {
    Reading asked = read(Direction.IN, "0001 0000 0006 ff 03 0080 0002");
    assertEquals("read-registers 128, count 2", asked.summary());
    Reading answered = read(Direction.OUT, "0001 0000 0007 ff 03 04 0005 ffff");
    assertEquals("values [5, 65535]", answered.summary());
  }

  @Test
  void saysWhatARequestSets() {
    Reading register = read(Direction.IN, "0007 0000 0006 ff 06 0080 002a");
    assertEquals(Optional.of("sets register 128 = 42"), register.effect());
    assertEquals(
        Map.of("transaction", 7, "unit", 255, "function", 6, "address", 128, "value", 42),
        register.fields().get());
    assertEquals(
        Optional.of("sets coil 16 = 1"),
        read(Direction.IN, "0007 0000 0006 ff 05 0010 ff00").effect());
    assertEquals(
        Optional.of("sets registers 128 to 129 = [1, 2]"),
        read(Direction.IN, "0007 0000 000b ff 10 0080 0002 04 0001 0002").effect());
  }

  @Test
  void readsARefusal() {
    assertEquals("refused, exception 2", read(Direction.OUT, "0001 0000 0003 ff 83 02").summary());
  }
}
