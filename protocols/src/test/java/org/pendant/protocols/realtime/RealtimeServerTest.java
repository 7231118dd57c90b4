package org.pendant.protocols.realtime;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.script.ScriptHandler;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;

class RealtimeServerTest {
  private static final int PROGRAM_STATE = 1052;
  private static final int DIGITAL_OUTPUTS = 1044;

  /** When a test has waited in vain. */
  private static final int MAX_FRAMES = 10_000;

  private final RemoteControl remote = new RemoteControl(true, true);
  private final RunningBox box = new RunningBox(ControllerOptions.headless(), remote);
  private final RealtimeServer server =
      RealtimeServer.open(
          box.serverContext(), PortNumbers.anyFree(), new ScriptHandler(box.serverContext()));

  private Socket connect(int port) throws IOException {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.ports().get(port).number());
    socket.setSoTimeout(RunningBox.GIVE_UP_MS);
    return socket;
  }

  private static ByteBuffer next(Socket socket) throws IOException {
    byte[] bytes = new byte[RealtimeCodec.BYTES];
    new DataInputStream(socket.getInputStream()).readFully(bytes);
    ByteBuffer read = ByteBuffer.wrap(bytes);
    assertEquals(RealtimeCodec.BYTES, read.getInt());
    return read;
  }

  private static void send(Socket socket, String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  @AfterEach
  void close() {
    server.close();
    box.close();
  }

  @Test
  void bothPortsSendEveryFrameInTurn() throws Exception {
    for (int port = 0; port < 2; port++) {
      try (Socket socket = connect(port)) {
        double before = next(socket).getDouble(4);
        for (int i = 0; i < 20; i++) {
          double now = next(socket).getDouble(4);
          assertEquals(0.002, now - before, 1e-9);
          before = now;
        }
      }
    }
  }

  @Test
  void takesScripts() throws Exception {
    try (Socket socket = connect(0)) {
      send(socket, "def p():\n  set_digital_out(2, True)\n  while True:\n    sync()\n  end\nend\n");
      ByteBuffer state = next(socket);
      for (int i = 0; state.getDouble(PROGRAM_STATE) != 2; i++) {
        assertTrue(i < MAX_FRAMES, "the program must have started");
        state = next(socket);
      }
      assertEquals(4, next(socket).getDouble(DIGITAL_OUTPUTS));
    }
  }

  @Test
  void theReadOnlyPortIgnoresThem() throws Exception {
    try (Socket reader = connect(1);
        Socket writer = connect(0)) {
      send(reader, "set_digital_out(2, True)\n");
      send(writer, "set_digital_out(1, True)\n");
      ByteBuffer state = next(reader);
      for (int i = 0; state.getDouble(DIGITAL_OUTPUTS) == 0; i++) {
        assertTrue(i < MAX_FRAMES, "the output must have been set");
        state = next(reader);
      }
      assertEquals(2, state.getDouble(DIGITAL_OUTPUTS));
    }
  }

  @Test
  void goingLocalDisconnectsThoseWhoCouldControl() throws Exception {
    try (Socket writer = connect(0);
        Socket reader = connect(1)) {
      next(writer);
      next(reader);
      remote.setRemote(false);
      byte[] rest = new byte[RealtimeCodec.BYTES];
      for (int i = 0; writer.getInputStream().read(rest) >= 0; i++) {
        assertTrue(i < MAX_FRAMES, "must have been disconnected");
      }
      next(reader);
    }
  }
}
