package org.pendant.protocols.realtime;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.state.ControllerState;

class RealtimeCodecTest {
  private final Controller controller = new Controller(ControllerOptions.headless());

  private void carryOut(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    controller.advance();
    assertEquals(new Reply.Done(), reply.join());
  }

  private ByteBuffer encoded() {
    return ByteBuffer.wrap(new RealtimeCodec().encode(controller.state()));
  }

  @Test
  void has1220BytesAndSaysSo() {
    ByteBuffer bytes = encoded();
    assertEquals(1220, bytes.capacity());
    assertEquals(1220, bytes.getInt(0));
  }

  @Test
  void everyFieldIsAtItsPlace() {
    carryOut(new IoCommand.SetInput("digital_in[0]", true));
    carryOut(new IoCommand.SetInput("digital_in[2]", true));
    carryOut(new BoxCommand.SetSpeedFraction(0.5));
    for (int i = 0; i < 97; i++) {
      controller.advance();
    }
    ControllerState state = controller.state();
    ByteBuffer bytes = encoded();
    assertEquals(0.2, bytes.getDouble(4), 1e-12, "time");
    for (int i = 0; i < 6; i++) {
      assertEquals(state.arm().targetPositionRad().get(i), bytes.getDouble(12 + 8 * i));
      assertEquals(state.readings().targetTorqueNm().get(i), bytes.getDouble(204 + 8 * i));
      assertEquals(state.arm().actualPositionRad().get(i), bytes.getDouble(252 + 8 * i));
      assertEquals(state.arm().actualTcpInBase().get(i), bytes.getDouble(444 + 8 * i), 1e-12);
      assertEquals(state.arm().targetTcpInBase().get(i), bytes.getDouble(588 + 8 * i), 1e-12);
      assertEquals(state.readings().temperatureC().get(i), bytes.getDouble(692 + 8 * i));
      assertEquals(253, bytes.getDouble(764 + 8 * i), "joint mode");
      assertTrue(bytes.getDouble(996 + 8 * i) > 40, "joint voltage");
      assertEquals(0, bytes.getDouble(820 + 8 * i), "reserved");
    }
    assertEquals(5, bytes.getDouble(684), "digital inputs");
    assertEquals(7, bytes.getDouble(756), "robot mode");
    assertEquals(1, bytes.getDouble(812), "safety mode");
    assertEquals(state.readings().toolAcceleration().zMPerS2(), bytes.getDouble(884));
    assertEquals(0, bytes.getDouble(940), "speed scaling without a program");
    assertEquals(48, bytes.getDouble(972), "main voltage");
    assertEquals(1, bytes.getDouble(1052), "program state");
    assertTrue(bytes.getDouble(1076) > 0.1, "height of the elbow");
    assertEquals(1, bytes.getDouble(1108), "safety status");
    assertEquals(0, bytes.getDouble(1140), "payload");
  }
}
