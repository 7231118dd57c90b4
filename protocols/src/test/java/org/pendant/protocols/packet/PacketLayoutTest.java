package org.pendant.protocols.packet;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.quantity.StateQuantities;

class PacketLayoutTest {
  private final Controller controller = new Controller(ControllerOptions.headless());

  private static PacketLayout.Builder packet(int bytes) {
    return new PacketLayout.Builder(bytes, ByteOrder.BIG_ENDIAN);
  }

  private byte[] encoded(PacketLayout.Builder packet) {
    return packet.build().encode(controller.state());
  }

  private String hex(PacketLayout.Builder packet) {
    return HexFormat.of().formatHex(encoded(packet));
  }

  private void write(SignalWrite... writes) {
    var _ = controller.submit(new IoCommand.WriteSignals("test", List.of(writes)));
    controller.advance();
  }

  @Test
  void constantsGapsAndQuantitiesStandInTheirOrder() {
    assertEquals(
        "00000009" + "0102" + "0000" + "07" + "3f800000",
        hex(
            packet(13)
                .int32(9)
                .bytes((byte) 1, (byte) 2)
                .skip(2)
                .put(WireType.INT8, "robot_mode")
                .put(WireType.FLOAT32, "speed_slider")));
  }

  @Test
  void aFieldbusHasTheLowestByteFirst() {
    write(new SignalWrite.IntegerRegister(RegisterDirection.OUTPUT, 3, -2));
    assertEquals(
        "feff" + "feffffff" + "feffffffffffffff" + "0000000000003e40",
        HexFormat.of()
            .formatHex(
                encoded(
                    new PacketLayout.Builder(22, ByteOrder.LITTLE_ENDIAN)
                        .put(WireType.INT16, StateQuantities.of("output_integer_register"), 3, 1)
                        .put(WireType.INT32, StateQuantities.of("output_integer_register"), 3, 1)
                        .put(WireType.INT64, StateQuantities.of("output_integer_register"), 3, 1)
                        .put(WireType.FLOAT64, state -> 30))));
  }

  @Test
  void unsignedBitsKeepTheHighestOne() {
    write(new SignalWrite.BooleanRegister(RegisterDirection.OUTPUT, 31, true));
    assertEquals(
        "80000000" + "00000000", hex(packet(8).put(WireType.INT32, "output_register_bits")));
  }

  @Test
  void quantitiesOfEachJointMayStandBesideEachOther() {
    PacketLayout.Builder packet = packet(6 * 12);
    for (int i = 0; i < 6; i++) {
      packet
          .put(WireType.FLOAT64, StateQuantities.of("actual_q"), i, 1)
          .put(WireType.FLOAT32, StateQuantities.of("temperature"), i, 1);
    }
    ByteBuffer bytes = ByteBuffer.wrap(encoded(packet));
    for (int i = 0; i < 6; i++) {
      assertEquals(controller.state().arm().actualPositionRad().get(i), bytes.getDouble());
      assertEquals((float) controller.state().readings().temperatureC().get(i), bytes.getFloat());
    }
  }

  @Test
  void whatStandsTwiceIsTheSame() {
    byte[] bytes =
        encoded(
            packet(12 * Double.BYTES)
                .put(WireType.FLOAT64, StateQuantities.of("actual_q"), 3, 3)
                .put(WireType.FLOAT64, "actual_q")
                .put(WireType.FLOAT64, StateQuantities.of("actual_q"), 0, 3));
    ByteBuffer all = ByteBuffer.wrap(bytes);
    for (int i = 0; i < 12; i++) {
      assertEquals(controller.state().arm().actualPositionRad().get((i + 3) % 6), all.getDouble());
    }
  }

  @Test
  void aPacketStaysAsItWasWhenTheNextOneIsMade() {
    PacketLayout layout = packet(8).put(WireType.INT64, "control_step").build();
    byte[] first = layout.encode(controller.state());
    byte[] kept = first.clone();
    controller.advance();
    layout.encode(controller.state());
    assertArrayEquals(kept, first);
  }

  @Test
  void whatDoesNotFitIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> packet(8).put(WireType.FLOAT64, "actual_q"));
  }
}
