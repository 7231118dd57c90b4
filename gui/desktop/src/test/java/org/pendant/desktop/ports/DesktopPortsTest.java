package org.pendant.desktop.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.ConnectException;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.service.PortWishes;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SharedCell;
import org.pendant.script.vm.ProgramState;

@Tag("slow")
@Timeout(60)
final class DesktopPortsTest {
  private static final int DASHBOARD = 29_999;
  private static final int PRIMARY = 30_001;

  @TempDir Path folder;

  private RobotSession session;
  private DesktopPorts ports;
  private PortWishes wishes;

  @BeforeEach
  void start() {
    session = RobotSession.start(ControllerOptions.headless());
    ports = new DesktopPorts(session, folder, visit -> {});
    wishes = FreePorts.wishes(folder);
  }

  @AfterEach
  void end() {
    session.close();
  }

  private Socket connect(int standardPort) throws IOException {
    return new Socket(FreePorts.address(wishes), standardPort + wishes.offset());
  }

  /** What the dashboard answers. */
  private String ask(String request) throws IOException {
    try (Socket socket = connect(DASHBOARD)) {
      BufferedReader in =
          new BufferedReader(
              new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
      assertTrue(in.readLine().startsWith("Connected"));
      socket.getOutputStream().write((request + "\n").getBytes(StandardCharsets.ISO_8859_1));
      return in.readLine();
    }
  }

  private PortsState.Trouble trouble() {
    return assertInstanceOf(PortsState.Closed.class, ports.state()).trouble().orElseThrow();
  }

  @Test
  void nobodyListensAtFirst() {
    assertEquals(PortsState.CLOSED, ports.state());
    assertThrows(ConnectException.class, () -> connect(DASHBOARD));
  }

  @Test
  void clientsReachTheControllerOfTheSession() throws IOException {
    ports.want(Optional.of(wishes));
    assertEquals("UR5", ask("get robot model"));
    assertEquals("true", ask("is in remote control"));
  }

  @Test
  void localControlIsToldToClients() throws IOException {
    ports.want(Optional.of(wishes));
    ports.setRemote(false);
    assertEquals("false", ask("is in remote control"));
  }

  @Test
  void closingLeavesNothingOpen() {
    ports.want(Optional.of(wishes));
    ports.want(Optional.empty());
    assertEquals(PortsState.CLOSED, ports.state());
    assertThrows(ConnectException.class, () -> connect(DASHBOARD));
    assertThrows(ConnectException.class, () -> connect(PRIMARY));
  }

  @Test
  void theEndOfTheSessionClosesThem() {
    ports.want(Optional.of(wishes));
    session.close();
    assertThrows(ConnectException.class, () -> connect(DASHBOARD));
  }

  @Test
  void theyFollowToAnotherRobotAndKeepLocalControl() throws IOException {
    ports.want(Optional.of(wishes));
    ports.setRemote(false);
    session.restart(session.options().withRobot("ur10e"));
    assertEquals("UR10", ask("get robot model"));
    assertEquals("false", ask("is in remote control"));
  }

  @Test
  void closedPortsStayClosedWithAnotherRobot() {
    session.restart(session.options().withRobot("ur10e"));
    assertEquals(PortsState.CLOSED, ports.state());
  }

  @Test
  void aPortThatIsTakenIsNamedAndKeepsNoOtherClosed() throws IOException {
    try (ServerSocket rtde =
            new ServerSocket(30_004 + wishes.offset(), 1, FreePorts.address(wishes));
        ServerSocket serial =
            new ServerSocket(54_321 + wishes.offset(), 1, FreePorts.address(wishes))) {
      ports.want(Optional.of(wishes));
      PortsState.Open open = assertInstanceOf(PortsState.Open.class, ports.state());
      assertEquals(
          List.of(
              "RTDE: port " + rtde.getLocalPort() + " of " + wishes.host() + " cannot be had",
              "Tool serial: port "
                  + serial.getLocalPort()
                  + " of "
                  + wishes.host()
                  + " cannot be had"),
          open.missing().stream()
              .map(each -> each.why().replaceAll("had: .*", "had"))
              .sorted()
              .toList());
      assertEquals("UR5", ask("get robot model"));
    }
  }

  @Test
  void withoutAnyPortTheyCountAsClosed() {
    RobotSession other = RobotSession.start(ControllerOptions.headless());
    try {
      DesktopPorts others = new DesktopPorts(other, folder, visit -> {});
      others.want(Optional.of(wishes));
      ports.want(Optional.of(wishes));
      assertTrue(trouble().text().contains("cannot be had"), trouble().text());
      assertEquals(PortField.OFFSET, trouble().field());
    } finally {
      other.close();
    }
    session.restart(session.options());
    assertThrows(ConnectException.class, () -> connect(PRIMARY), "not tried again unasked");
  }

  @Test
  void aFolderThatIsNotThereIsRefused() {
    Path missing = folder.resolve("missing");
    ports.want(
        Optional.of(
            new PortWishes(wishes.host(), wishes.offset(), wishes.modbus(), missing, true)));
    assertEquals(new PortsState.Trouble(PortField.PROGRAMS, missing + " is no folder"), trouble());
  }

  @Test
  void anAddressOfAnotherComputerIsRefused() {
    ports.want(
        Optional.of(new PortWishes("192.0.2.1", wishes.offset(), wishes.modbus(), folder, true)));
    assertEquals(
        new PortsState.Trouble(PortField.HOST, "192.0.2.1 is no address of this computer"),
        trouble());
  }

  @Test
  void anUploadedProgramRunsAndIsNoneOfTheSession() throws Exception {
    CompletableFuture<ControllerState> runs = new CompletableFuture<>();
    session.addFrameListener(
        state -> {
          if (state.program().state() == ProgramState.RUNNING) {
            runs.complete(state);
          }
        });
    ports.want(Optional.of(wishes));
    assertFalse(session.strangerLast());
    try (Socket socket = connect(PRIMARY)) {
      String text = "def visitor():\n  while True:\n    sync()\n  end\nend\n";
      socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
      assertEquals("visitor", runs.get(30, TimeUnit.SECONDS).program().name());
    }
    assertTrue(session.strangerLast());
    assertEquals(1, session.strangersStarted());
  }

  @Test
  void eachArmOfACellHasItsPortsWhereTheFileWantsThem() throws Exception {
    String row = wishes.host().substring(0, wishes.host().lastIndexOf('.'));
    session.restart(SharedCell.setup(SharedCell.SCENE.replace("127.0.0", row)));
    ports.want(Optional.of(wishes));
    PortsState.Open open = assertInstanceOf(PortsState.Open.class, ports.state());
    assertEquals(
        List.of("left " + row + ".2", "right " + row + ".3"),
        open.ports().stream()
            .map(each -> each.controller() + " " + each.address())
            .distinct()
            .toList());
    session.show("right");
    assertEquals(open, ports.state(), "who looks at another arm disturbs no client");
  }
}
