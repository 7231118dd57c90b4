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
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

final class PortInspectionTest {
  private static final StandardPort RTDE = new StandardPort(30_004, FindingText.of("RTDE"), false);

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
    StandardPort free = port(freePort(), "dashboard");

    assertEquals(List.of(PlainFindings.ok("Ports", "free: " + free.number())), findings(free));
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void portThatThisProcessHasIsNoProblem() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      assertOwn(port(socket.getLocalPort(), "RTDE"));
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void portOfDatagramsThatThisProcessHasIsNoProblem() throws IOException {
    InetSocketAddress any = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
    try (DatagramSocket socket = new DatagramSocket(any)) {
      assertOwn(new StandardPort(socket.getLocalPort(), FindingText.of("EtherNet/IP"), true));
    }
  }

  private static void assertOwn(StandardPort port) {
    assertEquals(
        List.of(
            PlainFindings.ok(
                "Port " + port.number(), port.words().english() + ": opened by this Pendant")),
        findings(port));
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void takenPortTellsWhoHasIt() throws IOException {
    listening();
    Path process = Files.createDirectories(folder.resolve("77/fd")).getParent();
    Files.writeString(process.resolve("comm"), "nc\n");
    Files.createSymbolicLink(process.resolve("fd/3"), Path.of("socket:[52011]"));

    assertEquals("30004 (RTDE): taken by nc, process 77", saidOf(RTDE));
  }

  @Test
  void processThatHasJustEndedIsSaidByItsNumber() throws IOException {
    listening();
    Path files = Files.createDirectories(folder.resolve("77/fd"));
    Files.createSymbolicLink(files.resolve("3"), Path.of("socket:[52011]"));

    assertEquals("30004 (RTDE): taken by process 77", saidOf(RTDE));
  }

  @Test
  void holderOfAnotherUserIsSaidToBeOne() throws IOException {
    listening();
    Files.createDirectories(folder.resolve("77"));

    assertEquals("30004 (RTDE): taken by a process of another user", saidOf(RTDE));
    assertTrue(new PortHolder(folder).of(port(30_003, "real-time")).isEmpty());
  }

  private static StandardPort port(int number, String protocol) {
    return new StandardPort(number, FindingText.of(protocol), false);
  }

  /** What is found at a port that is not free, by the processes in the folder. */
  private String saidOf(StandardPort port) {
    Finding finding = PortInspection.taken(port, new PortHolder(folder).of(port));
    assertEquals(Finding.Level.PROBLEM, finding.level());
    return finding.found().english();
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
    String said = saidOf(RTDE);

    assertTrue(said.startsWith("30004 (RTDE): taken by another program ("), said);
    assertTrue(said.endsWith(":30004 tells which)"), said);
  }

  @Test
  void portThatTheSystemKeepsForOthersIsOpenedAtAnotherNumber() {
    assertEquals(
        PlainFindings.note(
            "Port 502",
            "Modbus: the system does not let you open it",
            "Pendant opens port 1502 instead; --modbus-port chooses another one"),
        PortInspection.taken(port(502, "Modbus"), Optional.empty()));
  }
}
