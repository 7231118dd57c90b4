package org.pendant.protocols.toolserial;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.Socket;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.WallClock;
import org.pendant.controller.external.Connectors;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.server.PortNumbers;

class ToolSerialServerTest {
  private static final int GIVE_UP_MS = 20_000;

  @Test
  void aProgramTalksToAToolThatIsAClient() throws Exception {
    try (ToolSerialLine line = new ToolSerialLine();
        ToolSerialServer server =
            ToolSerialServer.open(line, PortNumbers.anyFree(), new PeerLog((level, text) -> {}))) {
      int port = server.ports().getFirst().number();
      Controller controller =
          new Controller(
              ControllerOptions.headless().withOutside(Connectors.NONE.withToolSerial(line)));
      try (FrameLoop loop = FrameLoop.start(controller, new WallClock());
          Socket tool = connect(port);
          Socket master = connect(port)) {
        String text = "set_tool_communication(True, 115200, 0, 1, 1.5, 3.5)\n";
        controller
            .submit(new ProgramCommand.StartProgram(TestController.program(controller, text)))
            .get();
        assertArrayEquals(new byte[] {1, 0, -1}, exchanged(master, tool, 1, 0, -1));
        assertArrayEquals(new byte[] {7}, exchanged(tool, master, 7));
        assertTrue(loop.failure().isEmpty());
      }
    }
  }

  private static Socket connect(int port) throws Exception {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
    socket.setSoTimeout(GIVE_UP_MS);
    return socket;
  }

  private static byte[] exchanged(Socket from, Socket to, int... bytes) throws Exception {
    for (int each : bytes) {
      from.getOutputStream().write(each);
    }
    return to.getInputStream().readNBytes(bytes.length);
  }
}
