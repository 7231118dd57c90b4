package org.pendant.protocols;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.protocols.modbus.ModbusServer;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.robotapi.RobotApiServer;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.MissingPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.teachpendant.PendantSetup;
import org.pendant.protocols.teachpendant.RemotePendant;

@Tag("slow")
class BoxPortsTest {
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  @TempDir Path folder;

  private RunningBox box;
  private RemotePendant remotePendant;

  @BeforeEach
  void start() {
    box = new RunningBox(ControllerOptions.headless(), RemoteControl.disabled());
    remotePendant =
        new RemotePendant(
            box.controller(), new PendantSetup("ur5e", ProgramsFolder.at(folder), folder));
  }

  @AfterEach
  void end() {
    box.close();
  }

  /**
   * A port that nobody uses, and that the system lends to nobody who takes any: those are higher.
   */
  private static int free() {
    return new Random().ints(15_000, 32_000).filter(BoxPortsTest::isFree).findFirst().orElseThrow();
  }

  private static boolean isFree(int port) {
    try (ServerSocket probe = new ServerSocket(port, 1, LOOPBACK)) {
      return probe.isBound();
    } catch (IOException e) {
      return false;
    }
  }

  private static void connect(int port) throws IOException {
    try (Socket socket = new Socket(LOOPBACK, port)) {
      assertTrue(socket.isConnected());
    }
  }

  @Test
  void everyPortListensUnderANameOfItsOwn() throws IOException {
    Set<String> names = new HashSet<>();
    try (BoxPorts ports =
        BoxPorts.open(box.serverContext(), PortNumbers.anyFree(), remotePendant)) {
      for (TcpPort each : ports.ports()) {
        connect(each.number());
        names.add(each.name());
      }
      assertEquals(ports.ports().size(), names.size());
      assertTrue(names.contains("Dashboard"), names.toString());
    }
  }

  @Test
  void theRobotApiIsThereWhereAPortIsChosenForIt() throws IOException {
    try (BoxPorts ports =
        BoxPorts.open(box.serverContext(), PortNumbers.anyFree(), remotePendant)) {
      assertTrue(ports.ports().stream().noneMatch(each -> each.name().equals("Robot API")));
    }
    PortNumbers numbers = PortNumbers.anyFree().with(RobotApiServer.STANDARD_PORT, 0);
    try (BoxPorts ports = BoxPorts.open(box.serverContext(), numbers, remotePendant)) {
      connect(
          ports.ports().stream()
              .filter(each -> each.name().equals("Robot API"))
              .findFirst()
              .orElseThrow()
              .number());
    }
  }

  @Test
  void closingClosesAllOfThem() throws IOException {
    BoxPorts ports = BoxPorts.open(box.serverContext(), PortNumbers.anyFree(), remotePendant);
    List<Integer> numbers = ports.ports().stream().map(TcpPort::number).toList();
    ports.close();
    for (int each : numbers) {
      assertThrows(ConnectException.class, () -> connect(each));
    }
  }

  @Test
  void whatWasClosedCanBeHadAgainAtOnce() throws IOException {
    PortNumbers numbers = PortNumbers.anyFree().with(29_999, free());
    for (int i = 0; i < 20; i++) {
      BoxPorts.open(box.serverContext(), numbers, remotePendant).close();
    }
  }

  @Test
  void aPortThatIsTakenIsNamedAndKeepsNoOtherClosed() throws IOException {
    int dashboard = free();
    try (ServerSocket taken = new ServerSocket(0, 1, LOOPBACK)) {
      PortNumbers numbers =
          PortNumbers.anyFree()
              .with(29_999, dashboard)
              .with(30_011, taken.getLocalPort())
              .with(ModbusServer.STANDARD_PORT, taken.getLocalPort());
      try (BoxPorts ports = BoxPorts.open(box.serverContext(), numbers, remotePendant)) {
        assertEquals(
            List.of(30_011, ModbusServer.STANDARD_PORT),
            ports.missing().stream().map(MissingPort::standardPort).toList());
        String why = ports.missing().getLast().why();
        assertTrue(why.startsWith("Modbus: port " + taken.getLocalPort()), why);
        connect(dashboard);
        for (TcpPort each : ports.ports()) {
          connect(each.number());
        }
      }
    }
  }
}
