package org.pendant.protocols.egress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HostPolicyTest {
  private static final int TIMEOUT_MS = 10_000;

  private final List<String> asked = new ArrayList<>();

  /** The name {@code here} is this computer; no other is known. */
  private InetAddress[] addresses(String host) throws UnknownHostException {
    asked.add(host);
    if (!host.equals("here")) {
      throw new UnknownHostException(host);
    }
    return new InetAddress[] {InetAddress.getLoopbackAddress()};
  }

  private HostPolicy reach(String allowed) {
    return new HostPolicy(AllowedHosts.parse(allowed), this::addresses);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "none | secret.data.example.invalid",
        "none | here",
        "camera.local | secret.data.example.invalid",
        "camera.local | camera.local.example.invalid",
        "localhost | here",
        "127.0.0.0/8,10.0.0.0/8,::/0 | here",
        "none | localhost",
        "none | 127.0.0.1",
        "10.0.0.0/8 | 127.0.0.1"
      })
  void nobodyIsAskedForANameThatIsNotAllowed(String allowed, String host) {
    IOException refused =
        assertThrows(HostNotAllowed.class, () -> reach(allowed).connect(host, 80, TIMEOUT_MS));
    assertEquals("not among the allowed hosts", refused.getMessage());
    assertEquals(List.of(), asked, "a question tells the name to others");
  }

  @Test
  void anAllowedNameIsAskedFor() {
    for (String allowed : List.of("any", "other.local", "OTHER.local, 10.0.0.1")) {
      assertThrows(
          UnknownHostException.class, () -> reach(allowed).connect("Other.local", 80, TIMEOUT_MS));
    }
    assertEquals(List.of("Other.local", "Other.local", "Other.local"), asked);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "any | here",
        "here | here",
        "any | localhost",
        "localhost | localhost",
        "localhost | 127.0.0.1",
        "127.0.0.0/8 | LocalHost",
        "127.0.0.1 | 127.0.0.1"
      })
  void whatIsAllowedIsReached(String allowed, String host) throws IOException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.ofLiteral("127.0.0.1"));
        Socket socket = reach(allowed).connect(host, server.getLocalPort(), TIMEOUT_MS)) {
      assertTrue(socket.isConnected());
    }
  }

  @Test
  void thisComputerNeedsNoAsking() throws IOException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.ofLiteral("127.0.0.1"));
        Socket socket = reach("any").connect("localhost", server.getLocalPort(), TIMEOUT_MS)) {
      assertTrue(socket.isConnected());
      assertEquals(List.of(), asked);
    }
  }
}
