package org.pendant.protocols.dashboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class DashboardClientTest {
  private static final String GREETING = "Connected: Universal Robots Dashboard Server\n";

  private final ServerSocket listening = listen();

  private static ServerSocket listen() {
    try {
      return new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @AfterEach
  void close() throws IOException {
    listening.close();
  }

  private DashboardClient talking(String greeting, String answer) throws IOException {
    Thread.ofVirtual()
        .start(
            () -> {
              try (Socket socket = listening.accept()) {
                socket.getOutputStream().write(greeting.getBytes(StandardCharsets.ISO_8859_1));
                if (socket.getInputStream().read(new byte[100]) > 0) {
                  socket.getOutputStream().write(answer.getBytes(StandardCharsets.ISO_8859_1));
                }
              } catch (IOException e) {
                throw new AssertionError(e);
              }
            });
    return DashboardClient.connect(
        new InetSocketAddress(listening.getInetAddress(), listening.getLocalPort()));
  }

  @Test
  void aLineIsAnsweredByALine() throws IOException {
    try (DashboardClient client = talking(GREETING, "Robotmode: RUNNING\r\n")) {
      assertEquals("Robotmode: RUNNING", client.ask("robotmode"));
    }
  }

  @Test
  void whatGreetsOtherwiseIsNoDashboard() {
    String why =
        assertThrows(IOException.class, () -> talking("220 mail\n", "").close()).getMessage();

    assertEquals("this is no dashboard, it does not greet as one", why);
  }

  @Test
  void aDashboardThatHangsUpIsToldAsThat() throws IOException {
    try (DashboardClient client = talking(GREETING, "no line end")) {
      assertThrows(EOFException.class, () -> client.ask("stop"));
    }
  }
}
