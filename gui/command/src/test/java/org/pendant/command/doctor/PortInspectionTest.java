package org.pendant.command.doctor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

final class PortInspectionTest {
  private static final StandardPort RTDE = new StandardPort(30_004, "RTDE", false);

  @TempDir private Path folder;

  private static List<Finding> findings(StandardPort... ports) {
    return new PortInspection(List.of(ports), new PortHolder()).findings();
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  @Test
  void freePortsAreOneLine() throws IOException {
    StandardPort free = new StandardPort(freePort(), "dashboard", false);

    assertEquals(List.of(Finding.ok("Ports", "free: " + free.number())), findings(free));
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void portThatThisProcessHasIsNoProblem() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      assertOwn(new StandardPort(socket.getLocalPort(), "RTDE", false));
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void portOfDatagramsThatThisProcessHasIsNoProblem() throws IOException {
    InetSocketAddress any = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
    try (DatagramSocket socket = new DatagramSocket(any)) {
      assertOwn(new StandardPort(socket.getLocalPort(), "EtherNet/IP", true));
    }
  }

  private static void assertOwn(StandardPort port) {
    assertEquals(
        List.of(Finding.ok("Port " + port.number(), port.words() + ": opened by this Pendant")),
        findings(port));
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void takenPortTellsWhoHasIt() throws IOException {
    listening();
    Path process = Files.createDirectories(folder.resolve("77/fd")).getParent();
    Files.writeString(process.resolve("comm"), "nc\n");
    Files.createSymbolicLink(process.resolve("fd/3"), Path.of("socket:[52011]"));

    assertEquals("nc, process 77", new PortHolder(folder).of(RTDE).get());
  }

  @Test
  void holderOfAnotherUserIsSaidToBeOne() throws IOException {
    listening();
    Files.createDirectories(folder.resolve("77"));
    PortHolder holder = new PortHolder(folder);

    assertEquals("a process of another user", holder.of(RTDE).get());
    assertTrue(holder.of(new StandardPort(30_003, "real-time", false)).isEmpty());
  }

  private void listening() throws IOException {
    Path net = Files.createDirectories(folder.resolve("net"));
    Files.writeString(
        net.resolve("tcp"),
        """
          sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode
           0: 0100007F:7534 00000000:0000 0A 00000000:00000000 00:00000000 00000000     0        0 52011 1
        """);
  }

  @Test
  void whereTheSystemDoesNotTellPeopleAreToldHowToAsk() {
    PortHolder holder = new PortHolder(folder.resolve("nothing"));

    assertTrue(holder.of(RTDE).isEmpty());
    assertTrue(holder.unknown(RTDE).contains(":30004"), holder.unknown(RTDE));
  }
}
