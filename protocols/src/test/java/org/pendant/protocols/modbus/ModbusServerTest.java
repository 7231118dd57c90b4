package org.pendant.protocols.modbus;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.WallClock;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;

class ModbusServerTest {
  private static final int GIVE_UP_MS = 20_000;

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final BlockingQueue<String> logged = new LinkedBlockingQueue<>();
  private final PeerLog log = new PeerLog((level, text) -> logged.add(text));
  private final StateBroadcaster frames = new StateBroadcaster(controller.feed(), log);
  private FrameLoop loop;
  private ModbusServer server;

  @BeforeEach
  void open() throws IOException {
    loop = FrameLoop.start(controller, new WallClock());
    server =
        ModbusServer.open(
            new ServerContext(controller, frames, log, RemoteControl.disabled()),
            PortNumbers.anyFree());
  }

  @AfterEach
  void close() {
    server.close();
    frames.close();
    loop.close();
  }

  private Socket connect() throws IOException {
    Socket socket =
        new Socket(InetAddress.getLoopbackAddress(), server.ports().getFirst().number());
    socket.setSoTimeout(GIVE_UP_MS);
    return socket;
  }

  private static void assertAnswer(Socket socket, String expected, String question)
      throws IOException {
    socket.getOutputStream().write(Hex.bytes(question));
    byte[] answer = Hex.bytes(expected);
    assertArrayEquals(answer, socket.getInputStream().readNBytes(answer.length));
  }

  @Test
  void whatOneClientWritesAnotherReads() throws Exception {
    try (Socket one = connect();
        Socket two = connect()) {
      assertAnswer(one, "0001 0000 0006 01 06 0080 04D2", "0001 0000 0006 01 06 0080 04D2");
      assertAnswer(two, "0007 0000 0005 01 03 02 04D2", "0007 0000 0006 01 03 0080 0001");
    }
  }

  @Test
  void answersSeveralRequestsOfOnePacketInTheirOrder() throws Exception {
    try (Socket socket = connect()) {
      assertAnswer(
          socket,
          "0001 0000 0006 01 06 0080 0005"
              + "0002 0000 0003 01 E3 01"
              + "0003 0000 0005 01 03 02 0005",
          "0001 0000 0006 01 06 0080 0005"
              + "0002 0000 0002 01 63"
              + "0003 0000 0006 01 03 0080 0001");
    }
  }

  @Test
  void passesOverFramesOfAnotherProtocolAndSaysSo() throws Exception {
    try (Socket socket = connect()) {
      assertAnswer(
          socket,
          "0002 0000 0005 01 03 02 0000",
          "0001 0001 0006 01 03 0080 0001" + "0002 0000 0006 01 03 0080 0001");
      String line = logged.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS);
      assertTrue(line.endsWith("passed over a frame of protocol 1, must be 0"), line);
    }
  }

  @Test
  void disconnectsWhoDoesNotSpeakModbusAndSaysSo() throws Exception {
    try (Socket socket = connect()) {
      socket.getOutputStream().write(Hex.bytes("4745 5420 2F20 4854 5450"));
      assertEquals(-1, socket.getInputStream().read());
      String line = logged.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS);
      assertTrue(line.endsWith("was disconnected: the length is 12064, must be 2 to 254"), line);
    }
  }

  @Test
  void clientsThatChangeBitsOfTheSameRegisterDoNotUndoEachOther() throws Exception {
    try (Socket one = connect();
        Socket two = connect()) {
      for (int bit = 0; bit < 16; bit++) {
        Socket socket = bit % 2 == 0 ? one : two;
        socket
            .getOutputStream()
            .write(
                Hex.bytes(
                    "0001 0000 0008 01 16 00FF %04X %04X"
                        .formatted(~(1 << bit) & 0xFFFF, 1 << bit)));
      }
      assertEquals(8 * 14, one.getInputStream().readNBytes(8 * 14).length);
      assertEquals(8 * 14, two.getInputStream().readNBytes(8 * 14).length);
      assertAnswer(one, "0001 0000 0005 01 03 02 FFFF", "0001 0000 0006 01 03 00FF 0001");
    }
  }

  @Test
  void aScriptSharesTheRegisters() throws Exception {
    try (Socket socket = connect()) {
      assertAnswer(socket, "0001 0000 0006 01 06 0080 8001", "0001 0000 0006 01 06 0080 8001");
      controller
          .submit(
              new ProgramCommand.StartProgram(
                  TestController.program(
                      controller, "write_port_register(129, read_port_register(128) + 1)")))
          .get(GIVE_UP_MS, TimeUnit.MILLISECONDS);
      for (String read = ""; !read.equals("8002"); ) {
        socket.getOutputStream().write(Hex.bytes("0002 0000 0006 01 03 0081 0001"));
        read = Hex.text(socket.getInputStream().readNBytes(11)).substring(18);
      }
    }
  }
}
