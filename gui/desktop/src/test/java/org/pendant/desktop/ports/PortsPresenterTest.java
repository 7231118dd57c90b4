package org.pendant.desktop.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.Socket;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.service.PortWishes;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.settings.Settings;

@Timeout(60)
final class PortsPresenterTest {
  @TempDir Path folder;

  private final Settings settings = new PreviewWorkbench().settings();
  private RobotSession session;
  private DesktopPorts ports;
  private PortsPresenter presenter;

  @BeforeEach
  void start() {
    session = RobotSession.start(ControllerOptions.headless());
    ports = new DesktopPorts(session, folder, visit -> {});
    presenter = new PortsPresenter(ports, settings, folder);
  }

  @AfterEach
  void end() {
    session.close();
  }

  private String refusal(PortField field, String text) {
    presenter.type(field, text);
    presenter.toggle();
    assertFalse(presenter.on());
    assertEquals(Optional.of(field), presenter.trouble().map(PortsState.Trouble::field));
    return presenter.trouble().orElseThrow().text();
  }

  @Test
  void itBeginsClosedAtTheLoopbackAddress() {
    assertFalse(presenter.on());
    assertTrue(presenter.rows().isEmpty());
    assertEquals("127.0.0.1", presenter.text(PortField.HOST));
    assertEquals(folder.toString(), presenter.text(PortField.PROGRAMS));
    assertTrue(presenter.remote());
  }

  @Test
  void whatIsTypedWronglyIsToldAtItsField() {
    assertEquals(
        "Offset is \"x\", must be a number from 0 to 11214", refusal(PortField.OFFSET, "x"));
    presenter.type(PortField.OFFSET, "0");
    assertEquals(Optional.empty(), presenter.trouble());
    assertEquals(
        "Modbus port is \"65536\", must be a number from 1 to 65535, or empty",
        refusal(PortField.MODBUS, "65536"));
    presenter.type(PortField.MODBUS, "");
    assertEquals(
        "Address is empty, must be an address of this computer", refusal(PortField.HOST, " "));
  }

  @Test
  void troubleIsForgottenWhenAFieldChanges() {
    PortWishes wishes = FreePorts.wishes(folder.resolve("missing"));
    ports.want(Optional.of(wishes));
    assertEquals(
        Optional.of(PortField.PROGRAMS), presenter.trouble().map(PortsState.Trouble::field));
    presenter.type(PortField.PROGRAMS, folder.toString());
    assertEquals(Optional.empty(), presenter.trouble());
  }

  @Test
  void everyPortHasItsAddressAndClients() throws Exception {
    PortWishes wishes = FreePorts.wishes(folder);
    ports.want(Optional.of(wishes));
    assertEquals("Open, nobody is connected", presenter.summary());
    int dashboard = 29_999 + wishes.offset();
    try (Socket socket = new Socket(FreePorts.address(wishes), dashboard)) {
      // greeted, so it is counted
      assertTrue(socket.getInputStream().read() >= 0);
      PortsPresenter.Row row =
          presenter.rows().stream().filter(each -> each.clients() > 0).findFirst().orElseThrow();
      assertEquals(
          new PortsPresenter.Row(
              "Dashboard",
              wishes.host() + ":" + dashboard,
              1,
              "127.0.0.1:" + socket.getLocalPort()),
          row);
      assertEquals("Open, 1 client", presenter.summary());
      assertEquals("", presenter.warning());
      assertFalse(presenter.changeable());
    }
  }

  @Test
  void whatWasTypedAndChosenIsThereNextTime() {
    presenter.type(PortField.OFFSET, "100");
    presenter.setRemote(false);
    PortsPresenter next = new PortsPresenter(ports, settings, folder);
    assertEquals("100", next.text(PortField.OFFSET));
    assertFalse(next.remote());
  }

  @Test
  void localControlIsSaid() {
    ports.want(Optional.of(FreePorts.wishes(folder)));
    presenter.setRemote(false);
    assertFalse(presenter.remote());
    assertEquals(
        "Open, nobody is connected. Local control: they may only ask", presenter.summary());
  }
}
