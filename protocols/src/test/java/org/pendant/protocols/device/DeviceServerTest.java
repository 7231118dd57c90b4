package org.pendant.protocols.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.WallClock;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.device.DeviceState;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;

class DeviceServerTest {
  private static final int GIVE_UP_MS = 20_000;

  private static final DeviceState TWO_FINGER =
      new DeviceState("gripper", "two-finger gripper", 0.085, 0.085, 0, false, 0.085, 0, 63_352);

  @Test
  void anOffsetThatLeavesNoRoomIsRefused() {
    Controller controller = new Controller(ControllerOptions.headless());
    PeerLog log = new PeerLog((level, text) -> {});
    try (StateBroadcaster frames = new StateBroadcaster(controller.feed(), log)) {
      ServerContext context =
          new ServerContext(controller, frames, log, new RemoteControl(false, true));
      PortNumbers numbers = new PortNumbers(InetAddress.getLoopbackAddress(), 4000, false);
      String why =
          assertThrows(IOException.class, () -> DeviceServer.open(context, numbers, TWO_FINGER))
              .getMessage();
      assertEquals(
          "Two-finger gripper would listen at port 67352, must be at most 65535: an offset of"
              + " 2183 leaves room",
          why);
    }
  }

  @Test
  void clientsFromOutsideTalkToTheGripper() throws Exception {
    Controller controller =
        new Controller(
            ControllerOptions.headless()
                .withEquipment(
                    CellEquipment.NONE.and(List.of(DeviceSetup.of("two-finger").orElseThrow()))));
    PeerLog log = new PeerLog((level, text) -> {});
    try (FrameLoop _ = FrameLoop.start(controller, new WallClock());
        StateBroadcaster frames = new StateBroadcaster(controller.feed(), log);
        DeviceServer server =
            DeviceServer.open(
                new ServerContext(controller, frames, log, new RemoteControl(false, true)),
                PortNumbers.anyFree(),
                controller.state().devices().getFirst());
        Socket client =
            new Socket(InetAddress.getLoopbackAddress(), server.ports().getFirst().number())) {
      client.setSoTimeout(GIVE_UP_MS);
      assertEquals("POS 3\n", said(client, "GET POS\n", 6));
      assertEquals("ack", said(client, "SET POS 255 GTO 1\n", 3));
      assertEquals("3", said(client, "GET STA", 1));
      assertEquals("255", said(client, "GET PRE", 3));
    }
  }

  private static String said(Socket client, String message, int bytes) throws Exception {
    client.getOutputStream().write(message.getBytes(StandardCharsets.ISO_8859_1));
    return new String(client.getInputStream().readNBytes(bytes), StandardCharsets.ISO_8859_1);
  }
}
