package org.pendant.window;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.pendant.client.Served;

/** The ports of the controller in the window, and a program that comes by them. */
@Tag("slow")
final class PortsWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private static final int PRIMARY = 30_001;
  private static final int ADDRESS = 220;
  private static final String OFFSET = "2000";

  private final OpenWindow window = sharedWindow.window();

  private void fill(String field, String text) {
    window.click(field);
    window.awaitFocus(field);
    window.press("control A");
    window.type(text);
  }

  @Test
  void aProgramFromOutsideRunsUnderItsOwnNameUntilItIsStoppedHere() throws IOException {
    sharedWindow.program("sleep(1)");
    window.perform("Show Ports");
    window.awaitShown("ports-open");
    InetAddress address = InetAddress.getByName(Served.host(ADDRESS));
    int port = PRIMARY + Integer.parseInt(OFFSET);
    fill("ports-host", address.getHostAddress());
    fill("ports-offset", OFFSET);
    window.click("ports-open");
    window.awaitWords("ports-summary", "Open,");
    window.click("ports-clients");
    window.awaitWords("clients-summary", "Nobody is connected");
    window.tabTo("clients-table");
    window.tabTo("clients-detail");
    try (Socket socket = new Socket(address, port)) {
      window.awaitWords("clients-table", "Primary");
      String text = "def visitor():\n  while True:\n    sync()\n  end\nend\n";
      socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
      window.clickCell("clients-messages", "sends the program def visitor():");
      window.awaitWords("clients-detail", "while True:");
      window.click("clients-moment");
      window.awaitShown("timeline-canvas");
      window.awaitWords("clients-detail", "while True:");
      window.perform("Timeline: back to now");
      window.click("rail-run");
      window.awaitWords("run-name", "visitor (sent from outside)");
      window.awaitWords("run-line", "Line 3:  sync()");
      window.awaitWords("program-state", "running");
      window.awaitWords("ports-summary", "1 client");
      window.awaitWords(
          "ports-table", "Primary | " + address.getHostAddress() + ":" + port + " | 1");
      window.click("rail-script");
      window.choose("script-tabs", "visitor.script");
      window.awaitShown("received-bar");
      window.awaitWords("script-text", "while True:");
      window.press("shift F5");
      window.awaitWords("program-state", "stopped");
      window.click("rail-run");
    }
    window.click("ports-open");
    window.awaitWords("ports-summary", "Closed");
    new ServerSocket(port, 1, address).close();
  }
}
