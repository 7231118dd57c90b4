package org.pendant.protocols.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.script.value.Value;

/** The link against bytes as the description of the protocol has them. */
class PrimaryLinkTest {
  private static final String VERSION =
      "00000037 14 FFFFFFFFFFFFFFFF FE 03 09 \"URControl\" 05 18 00000000 00000000"
          + " \"04-10-2025, 00:25:33\"";

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

  /** A controller that sends these packages and closes the connection. */
  private PrimaryLink linked(String... packages) throws IOException {
    Thread.ofVirtual()
        .start(
            () -> {
              try (Socket socket = listening.accept()) {
                for (String each : packages) {
                  socket
                      .getOutputStream()
                      .write(HexFormat.of().parseHex(RobotMessageCodecTest.hex(each)));
                }
              } catch (IOException e) {
                throw new AssertionError(e);
              }
            });
    return PrimaryLink.connect(
        new InetSocketAddress(listening.getInetAddress(), listening.getLocalPort()));
  }

  private static List<RobotMessage> all(PrimaryLink link) {
    while (link.lost().isEmpty()) {
      Thread.onSpinWait();
    }
    return link.take();
  }

  @Test
  void hearsWhatProgramsDo() throws IOException {
    long timeUs = 12_345_678_000L;
    try (PrimaryLink link =
        linked(
            VERSION,
            "00000014 14 00000002DFDC18B0 FD 00 \"hello\"",
            "0000002F 14 00000002DFDC18B0 FD 07 00000000 00000000 13 \"PROGRAM_XXX_STARTED\""
                + " \"prog\"",
            "00000032 14 00000002DFDC18B0 FD 0A 00000002 00000001"
                + " \"syntax_error_on_line:2:end:\"",
            "00000023 14 00000002DFDC18B0 FD 06 00000099 00000002 00000003 00000000 00000000",
            "0000001B 14 00000002DFDC18B0 FD 02 00000000 00 00 00 01 01 \"T\" \"hi\"",
            "0000001B 14 00000002DFDC18B0 FD 09 00000001 02 \"Offset?\"")) {
      List<RobotMessage> heard = new ArrayList<>(all(link));

      assertEquals(new RobotMessage.Version(), heard.removeFirst());
      assertEquals(
          List.of(
              new RobotMessage.Text(timeUs, "hello"),
              new RobotMessage.Key(timeUs, "PROGRAM_XXX_STARTED", "prog"),
              new RobotMessage.RuntimeFault(timeUs, 2, 1, "syntax_error_on_line:2:end:"),
              new RobotMessage.ErrorCode(timeUs, 153, 2, RobotMessage.Level.VIOLATION, ""),
              new RobotMessage.Request(timeUs, 0, RobotMessage.Wanted.NOTHING, "T: hi"),
              new RobotMessage.Request(timeUs, 1, RobotMessage.Wanted.FLOAT, "Offset?")),
          heard);
      assertEquals("it has closed the connection", link.lost().orElseThrow());
    }
  }

  @Test
  void hearsVariables() throws IOException {
    try (PrimaryLink link =
        linked(
            VERSION,
            "00000014 19 00000002DFDC18B0 00 0000 610A 620A",
            "00000019 19 00000002DFDC18B0 01 0000 0F 00000005 0A 0D 01 0A",
            "00000005 10")) {
      all(link);

      assertEquals(
          new ProgramVariables(1, 1, Map.of("a", Value.of(5), "b", Value.of(true))),
          link.variables());
    }
  }

  @Test
  void hearsMessagesAlsoWhereVariablesCannotBeRead() throws IOException {
    try (PrimaryLink link =
        linked(
            VERSION,
            "00000012 19 00000002DFDC18B0 01 0000 63 0A",
            "00000014 14 00000002DFDC18B0 FD 00 \"hello\"")) {
      assertEquals(new RobotMessage.Text(12_345_678_000L, "hello"), all(link).getLast());
      assertEquals(ProgramVariables.NONE, link.variables());
    }
  }

  @Test
  void readsWhatTheCodecWrites() {
    List<RobotMessage> messages =
        List.of(
            new RobotMessage.Text(1, "a"),
            new RobotMessage.ErrorCode(2, 3, 4, RobotMessage.Level.WARNING, "b"),
            new RobotMessage.Key(5, "title", "c"),
            new RobotMessage.Request(6, 0xFFFFFFFFL, RobotMessage.Wanted.BOOLEAN, "d"),
            new RobotMessage.RuntimeFault(7, 8, 9, "e"));
    for (RobotMessage each : messages) {
      ByteBuffer body = ByteBuffer.wrap(RobotMessageCodec.encode(each)).position(5).slice();
      assertEquals(each, RobotMessageDecoder.decode(body).orElseThrow());
    }
  }

  @Test
  void whatIsNoPrimaryPortIsCalledThat() {
    String why =
        assertThrows(IOException.class, () -> linked("\"Connected: Universal Robots\""))
            .getMessage();

    assertTrue(why.startsWith("this is no primary port"), why);
  }

  @Test
  void aMessageThatIsCutOffEndsTheConnection() throws IOException {
    try (PrimaryLink link = linked(VERSION, "00000010 14 00000002DFDC18B0 FD 0A 00")) {
      all(link);

      assertEquals("a message of the primary port is cut off", link.lost().orElseThrow());
    }
  }
}
