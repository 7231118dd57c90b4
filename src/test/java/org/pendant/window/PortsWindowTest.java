package org.pendant.window;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** The ports of the controller in the window, and a program that comes by them. */
final class PortsWindowTest {
  @RegisterExtension static final SharedWindow desk = new SharedWindow();

  private static final int PRIMARY = 30_001;
  private static final int FIRST_OFFSET = 3000;
  private static final int LAST_OFFSET = 9000;

  private final OpenWindow window = desk.window();

  /** Opens the ports where nobody uses any of them; answers the offset. */
  private int openPorts() {
    for (int offset = FIRST_OFFSET; offset < LAST_OFFSET; offset += 500) {
      window.click("ports-offset");
      window.awaitFocus("ports-offset");
      window.press("control A");
      window.type(Integer.toString(offset));
      window.click("ports-open");
      window.await(
          "they are open or refused",
          () -> window.words("ports-summary").startsWith("Open,") || window.shows("ports-problem"));
      if (window.words("ports-summary").startsWith("Open,")) {
        return offset;
      }
    }
    throw new AssertionError("no offset was free");
  }

  @Test
  void aProgramFromOutsideRunsUnderItsOwnNameUntilItIsStoppedHere() throws IOException {
    desk.program("sleep(1)");
    window.perform("Show Ports");
    window.awaitShown("ports-open");
    int offset = openPorts();
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), PRIMARY + offset)) {
      String text = "def visitor():\n  while True:\n    sync()\n  end\nend\n";
      socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
      window.awaitWords("run-name", "visitor (sent from outside)");
      window.awaitWords("program-state", "running");
      window.awaitWords("ports-summary", "1 client");
      window.awaitWords("ports-table", "Primary | 127.0.0.1:" + (PRIMARY + offset) + " | 1");
      window.press("shift F5");
      window.awaitWords("program-state", "stopped");
    }
    window.click("ports-open");
    window.awaitWords("ports-summary", "Closed");
    new ServerSocket(PRIMARY + offset, 1, InetAddress.getLoopbackAddress()).close();
  }
}
