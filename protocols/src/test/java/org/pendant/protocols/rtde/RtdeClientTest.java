package org.pendant.protocols.rtde;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.rtde.FieldType;
import org.pendant.protocols.rtde.RtdeClient.Subscription;

/** The client against bytes as the description of the protocol has them. */
class RtdeClientTest {
  private static final String ASKS_FOR_VERSION_2 = "0005 56 0002";
  private static final String ACCEPTED_VERSION = "0004 56 01";

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

  /**
   * A controller that expects what it is asked, answers each, and closes the connection.
   *
   * @param turns request and answer in turns, in hexadecimal
   * @return what it was asked
   */
  private CompletableFuture<List<String>> controller(String... turns) {
    return CompletableFuture.supplyAsync(
        () -> {
          try (Socket socket = listening.accept()) {
            List<String> asked = new ArrayList<>();
            for (int i = 0; i < turns.length; i += 2) {
              int expected = bytes(turns[i]).length;
              asked.add(HexFormat.of().formatHex(socket.getInputStream().readNBytes(expected)));
              socket.getOutputStream().write(bytes(turns[i + 1]));
            }
            return asked;
          } catch (IOException e) {
            throw new AssertionError(e);
          }
        });
  }

  private static byte[] bytes(String hex) {
    return HexFormat.of().parseHex(hex.replace(" ", ""));
  }

  private RtdeClient connect() throws IOException {
    return RtdeClient.connect(
        new InetSocketAddress(listening.getInetAddress(), listening.getLocalPort()));
  }

  private static Optional<ByteBuffer> data(RtdeClient client) throws IOException {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(20);
    Optional<ByteBuffer> data = client.next();
    while (data.isEmpty() && System.nanoTime() < endNs) {
      data = client.next();
    }
    return data;
  }

  @Test
  void readsFieldsOfEveryType() throws Exception {
    // 125 Hz, "timestamp,runtime_state,payload_cog,on,joint_mode"
    String recipe =
        "003c 4f 405f400000000000"
            + "74696d657374616d70 2c 72756e74696d655f7374617465 2c 7061796c6f61645f636f67"
            + "2c 6f6e 2c 6a6f696e745f6d6f6465";
    // recipe 1, "DOUBLE,UINT32,VECTOR3D,BOOL,VECTOR6INT32"
    String types =
        "002c 4f 01 444f55424c45 2c 55494e543332 2c 564543544f523344 2c 424f4f4c 2c"
            + "564543544f5236494e543332";
    String warning = "000c 4d 02 6f6b 04 52544445 01";
    String row =
        "0041 55 01 3ff8000000000000 ffffffff 0000000000000000 bff0000000000000 4000000000000000"
            + " 01 00000001 00000002 00000003 00000004 00000005 fffffffa";
    CompletableFuture<List<String>> asked =
        controller(
            ASKS_FOR_VERSION_2,
            ACCEPTED_VERSION,
            "0003 76",
            "0013 76 00000005 00000018 00000001 00000002",
            recipe,
            types,
            "0003 53",
            "0004 53 01" + warning + row);

    try (RtdeClient client = connect()) {
      assertEquals("5.24.1.2", client.controllerVersion());
      Subscription.Granted granted =
          assertInstanceOf(
              Subscription.Granted.class,
              client.subscribe(
                  125, List.of("timestamp", "runtime_state", "payload_cog", "on", "joint_mode")));
      client.start();
      ByteBuffer data = data(client).orElseThrow();
      StringBuilder cells = new StringBuilder();
      List<String> columns = new ArrayList<>();
      for (ReceivedField each : granted.fields()) {
        columns.addAll(each.columns());
        each.append(data, ' ', cells);
        cells.append(' ');
      }

      assertEquals("1.5 4294967295 0.0 -1.0 2.0 True 1 2 3 4 5 -6 ", cells.toString());
      assertEquals(
          List.of(
              "timestamp",
              "runtime_state",
              "payload_cog_0",
              "payload_cog_1",
              "payload_cog_2",
              "on",
              "joint_mode_0",
              "joint_mode_1",
              "joint_mode_2",
              "joint_mode_3",
              "joint_mode_4",
              "joint_mode_5"),
          columns);
      assertThrows(EOFException.class, () -> data(client));
    }
    assertEquals(
        List.of("0005560002", "000376", recipe.replace(" ", ""), "000353"),
        asked.get(20, TimeUnit.SECONDS));
  }

  @Test
  void namesTheFieldsThatAControllerDoesNotHave() throws Exception {
    // "a,b" answered by "DOUBLE,NOT_FOUND"
    CompletableFuture<List<String>> asked =
        controller(
            ASKS_FOR_VERSION_2,
            ACCEPTED_VERSION,
            "000e 4f 407f400000000000 61 2c 62",
            "0014 4f 00 444f55424c45 2c 4e4f545f464f554e44");

    try (RtdeClient client = connect()) {
      assertEquals(
          new Subscription.Unknown(List.of("b")), client.subscribe(500, List.of("a", "b")));
    }
    assertEquals(2, asked.get(20, TimeUnit.SECONDS).size());
  }

  @Test
  void aControllerThatOnlySpeaksVersionOneIsRefused() {
    var _ = controller(ASKS_FOR_VERSION_2, "0004 56 00");
    IOException refusal = assertThrows(IOException.class, this::connect);
    assertTrue(refusal.getMessage().contains("version 2"), refusal.getMessage());
  }

  @Test
  void whatIsNoRtdeIsRefused() {
    var _ = controller(ASKS_FOR_VERSION_2, "0000 0000");
    IOException refusal = assertThrows(IOException.class, this::connect);
    assertTrue(refusal.getMessage().contains("this is no RTDE"), refusal.getMessage());
  }

  @Test
  void aFieldIsOneColumnOrSeveral() {
    assertEquals(List.of("payload"), new ReceivedField("payload", FieldType.DOUBLE).columns());
    assertEquals(
        List.of("q_0", "q_1", "q_2", "q_3", "q_4", "q_5"),
        new ReceivedField("q", FieldType.VECTOR6D).columns());
  }
}
