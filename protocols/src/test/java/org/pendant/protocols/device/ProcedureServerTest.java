package org.pendant.protocols.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;

class ProcedureServerTest {
  private static final int GIVE_UP_MS = 20_000;
  private static final int GRIP_SERVER = 41_414;

  @Test
  void clientsFromOutsideCallTheGrippersOfAPort() throws Exception {
    Controller controller =
        new Controller(
            ControllerOptions.headless()
                .withEquipment(
                    CellEquipment.NONE.and(
                        List.of(
                            DeviceSetup.of("rg").orElseThrow(),
                            DeviceSetup.of("2fg").orElseThrow()))));
    PeerLog log = new PeerLog((level, text) -> {});
    try (FrameLoop _ = FrameLoop.start(controller, new WallClock());
        StateBroadcaster frames = new StateBroadcaster(controller.feed(), log)) {
      ServerContext context =
          new ServerContext(controller, frames, log, new RemoteControl(false, true));
      assertEquals(List.of(GRIP_SERVER), ProcedureServer.wanted(context));
      try (ProcedureServer server =
          ProcedureServer.open(context, PortNumbers.anyFree(), GRIP_SERVER)) {
        int port = server.ports().getFirst().number();
        String width = called(port, "rg_get_width", "<int>0</int>");
        assertTrue(width.contains("<double>110"), width);
        String other = called(port, "twofg_get_external_width", "<int>0</int>");
        assertTrue(other.contains("<double>39"), other);
        String unknown = called(port, "rg_jump", "<int>0</int>");
        assertTrue(unknown.contains("rg_jump: no such procedure of rg, 2fg"), unknown);
        String wrong = called(port, "rg_grip", "<string>wide</string>");
        assertTrue(wrong.contains("argument 1 is wide, must be a number"), wrong);
      }
    }
  }

  private static String called(int port, String method, String value) throws Exception {
    String body =
        "<?xml version='1.0'?><methodCall><methodName>"
            + method
            + "</methodName><params><param><value>"
            + value
            + "</value></param></params></methodCall>";
    try (Socket client = new Socket(InetAddress.getLoopbackAddress(), port)) {
      client.setSoTimeout(GIVE_UP_MS);
      client
          .getOutputStream()
          .write(
              ("POST /RPC2 HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nContent-Length: "
                      + body.length()
                      + "\r\n\r\n"
                      + body)
                  .getBytes(StandardCharsets.ISO_8859_1));
      return new String(client.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
