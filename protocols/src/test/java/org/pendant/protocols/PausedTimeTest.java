package org.pendant.protocols;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.HexFormat;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.Pace;
import org.pendant.controller.SteerableClock;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.message.Operator;
import org.pendant.controller.state.StateStream;
import org.pendant.protocols.dashboard.DashboardServer;
import org.pendant.protocols.dashboard.DashboardTalk;
import org.pendant.protocols.modbus.ModbusServer;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.rtde.Client;
import org.pendant.protocols.rtde.RtdeServer;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.teachpendant.PendantSetup;
import org.pendant.protocols.teachpendant.RemotePendant;

/** Clients are served while robot time is paused, and their commands cost no frame. */
class PausedTimeTest {
  private static final int FRAMES_BEFORE = 10;
  private static final int REGISTER = 24;

  @TempDir Path folder;

  private final Controller controller =
      new Controller(ControllerOptions.headless().withOperator(Operator.present()));
  private final PeerLog log = new PeerLog((level, text) -> {});
  private final StateBroadcaster frames = new StateBroadcaster(controller.feed(), log);
  private final ServerContext serverContext =
      new ServerContext(controller, frames, log, RemoteControl.disabled());
  private FrameLoop loop;
  private double pausedAtS;

  @BeforeEach
  void pauseAfterSomeFrames() {
    for (int i = 0; i < FRAMES_BEFORE; i++) {
      controller.advance();
    }
    pausedAtS = controller.state().timeS();
    loop = FrameLoop.start(controller, new SteerableClock(new Pace.Paused()));
  }

  @AfterEach
  void close() {
    loop.close();
    frames.close();
  }

  private void assertTimeStands() {
    assertEquals(FRAMES_BEFORE, controller.state().frame());
    assertEquals(pausedAtS, controller.state().timeS());
  }

  @Test
  void theDashboardShowsAPopup() throws Exception {
    RemotePendant remotePendant =
        new RemotePendant(controller, new PendantSetup("ur5e", ProgramsFolder.at(folder), folder));
    try (DashboardServer server =
            DashboardServer.open(serverContext, PortNumbers.anyFree(), remotePendant);
        DashboardTalk client = new DashboardTalk(server.ports().getFirst().number())) {
      assertEquals("showing popup", client.ask("popup Close the door"));
      assertEquals(1, controller.state().openPopups().size());
      assertTimeStands();
      assertEquals("closing popup", client.ask("close popup"));
      assertEquals(0, controller.state().openPopups().size());
      assertTimeStands();
    }
  }

  @Test
  void aModbusClientReadsWhatItHasWritten() throws Exception {
    try (ModbusServer server = ModbusServer.open(serverContext, PortNumbers.anyFree());
        Socket client =
            new Socket(InetAddress.getLoopbackAddress(), server.ports().getFirst().number())) {
      client.setSoTimeout(RunningBox.GIVE_UP_MS);
      String write = "00010000000601060080" + "04d2";
      assertAnswer(client, write, write);
      assertAnswer(client, "000200000005010302" + "04d2", "000200000006010300800001");
      assertTimeStands();
    }
  }

  private static void assertAnswer(Socket client, String expected, String question)
      throws IOException {
    client.getOutputStream().write(HexFormat.of().parseHex(question));
    byte[] answer = HexFormat.of().parseHex(expected);
    assertArrayEquals(answer, client.getInputStream().readNBytes(answer.length));
  }

  @Test
  void anRtdeInputArrives() throws Exception {
    try (RtdeServer server = RtdeServer.open(serverContext, PortNumbers.anyFree());
        Client client = Client.speaking2(server.ports().getFirst().number());
        StateStream.Subscription snapshots = controller.feed().follow()) {
      assertEquals("1 INT32", client.inputs("input_int_register_" + REGISTER));
      client.send('U', ByteBuffer.allocate(5).put((byte) 1).putInt(4711).array());
      while (controller.state().signals().inputs().integer(REGISTER) != 4711) {
        snapshots.take();
      }
      assertTimeStands();
    }
  }
}
