package org.pendant.protocols.modbusclient;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.protocols.ClosedPort;
import org.pendant.protocols.Peer;
import org.pendant.protocols.ScriptRun;
import org.pendant.protocols.egress.AllowedHosts;

@Timeout(60)
@Tag("slow")
class ModbusClientsTest {
  /** Waits until a signal has been answered, or the program fails. */
  private static final String UNTIL_VALID =
      """
        def until_valid(name):
          while modbus_get_error(name) != 0:
            sync()
          end
        end
        def until_error(name, error):
          while modbus_get_error(name, 2) != error:
            sync()
          end
        end
      """;

  private final FakeDevice device = new FakeDevice();

  private static List<String> run(ScriptRun script, Peer peer, String lines)
      throws InterruptedException {
    return script.run(UNTIL_VALID + lines.replace("DEVICE", "\"127.0.0.1:" + peer.port() + "\""));
  }

  private List<String> run(String lines) throws Exception {
    try (Peer peer = Peer.that(device);
        ScriptRun script = new ScriptRun()) {
      return run(script, peer, lines);
    }
  }

  @Test
  void readsEveryKindOfSignal() throws Exception {
    device.setCoil(3, true);
    device.setRegister(10, 65535);
    device.setRegister(11, 12);
    assertEquals(
        List.of("True", "False", "[False, True]", "65535", "[65535, 12]", "[12, 0, 0]"),
        run(
            """
              modbus_add_signal(DEVICE, 255, 3, 0, "in")
              modbus_add_signal(DEVICE, 255, 2, 1, "out")
              modbus_add_signal(DEVICE, 255, 2, 15, "outs", False, 2)
              modbus_add_signal(DEVICE, 255, 10, 2, "register")
              modbus_add_signal(DEVICE, 255, 10, 3, "registers", False, 2)
              modbus_add_rw_signal(DEVICE, 255, 11, 3, 20, 2, "both")
              until_valid("in")
              until_valid("out")
              until_valid("outs")
              until_valid("register")
              until_valid("registers")
              until_valid("both")
              textmsg(modbus_get_signal_status("in"))
              textmsg(modbus_get_signal_status("out"))
              textmsg(modbus_get_signal_status("outs"))
              textmsg(modbus_get_signal_status("register"))
              textmsg(modbus_get_signal_status("registers"))
              textmsg(modbus_get_signal_status("both"))
            """));
  }

  @Test
  void writesEveryKindOfOutputAlsoWhenTheProgramEndsAtOnce() throws Exception {
    device.setRegister(42, 42);
    run(
        """
          modbus_add_signal(DEVICE, 1, 1, 1, "out")
          modbus_add_signal(DEVICE, 1, 2, 15, "outs", False, 3)
          modbus_add_signal(DEVICE, 1, 30, 3, "register")
          modbus_add_signal(DEVICE, 1, 40, 16, "registers", False, 3)
          modbus_add_rw_signal(DEVICE, 1, 11, 3, 50, 2, "both")
          until_valid("registers")
          modbus_set_output_signal("out", True)
          modbus_set_output_signal("outs", [True, False, True])
          modbus_set_output_register("register", 30000)
          modbus_set_output_register("registers", [40, 41])
          modbus_set_output_register("both", [50, 51])
        """);
    assertTrue(device.coil(1));
    assertTrue(device.coil(2));
    assertFalse(device.coil(3));
    assertTrue(device.coil(4));
    assertEquals(30_000, device.register(30));
    assertEquals(40, device.register(40));
    assertEquals(41, device.register(41));
    assertEquals(42, device.register(42));
    assertEquals(51, device.register(51));
    assertTrue(device.asked().contains("1 6 30 30000"));
    assertTrue(device.asked().contains("1 16 40 3"));
    assertTrue(device.asked().contains("1 23 11 3"));
  }

  @Test
  void readsOnDemandOnly() throws Exception {
    try (Peer peer = Peer.that(device);
        ScriptRun script = new ScriptRun()) {
      run(
          script,
          peer,
          """
            modbus_add_signal(DEVICE, 1, 5, 2, "s")
            modbus_set_signal_update_frequency("s", 0)
            until_valid("s")
          """);
      int before = device.asked().size();
      device.setRegister(5, 7);
      assertEquals(
          List.of("7"),
          run(
              script,
              peer,
              """
                sleep(0.5)
                modbus_request_update_signal_value("s")
                sleep(0.5)
                modbus_set_signal_update_frequency("s", -1)
                while modbus_get_signal_status("s") != 7:
                  sleep(0.05)
                end
                textmsg(modbus_get_signal_status("s"))
              """));
      assertTrue(device.asked().size() <= before + 5, () -> device.asked().toString());
    }
  }

  @Test
  void anOutputOnDemandIsWrittenOnceForEachSetting() throws Exception {
    run(
        """
          modbus_add_signal(DEVICE, 1, 5, 3, "s")
          modbus_set_signal_update_frequency("s", 0)
          until_valid("s")
          modbus_set_output_register("s", 3)
          sleep(0.3)
          modbus_set_output_register("s", 4)
          sleep(0.3)
        """);
    assertEquals(1, Collections.frequency(device.asked(), "1 6 5 4"), device.asked().toString());
  }

  @Test
  void aRefusalIsTheDevicesErrorUntilItAnswersAgain() throws Exception {
    try (Peer peer = Peer.that(device);
        ScriptRun script = new ScriptRun()) {
      device.refuse(4);
      assertEquals(
          List.of("4"),
          run(
              script,
              peer,
              """
                modbus_add_signal(DEVICE, 1, 5, 2, "s")
                until_error("s", 0)
                textmsg(modbus_get_error("s"))
              """));
      device.refuse(0);
      assertEquals(
          List.of("4", "0"),
          run(script, peer, "  until_valid(\"s\")\n  textmsg(modbus_get_error(\"s\"))\n"));
    }
  }

  @Test
  void aDeviceThatGoesAndComesBackIsFoundAgain() throws Exception {
    CountDownLatch found = new CountDownLatch(1);
    CountDownLatch missed = new CountDownLatch(1);
    AtomicInteger connections = new AtomicInteger();
    Peer.Conversation leaving =
        client -> {
          if (connections.incrementAndGet() == 1) {
            DataInputStream in = new DataInputStream(client.getInputStream());
            client.getOutputStream().write(device.answer(FakeDevice.read(in)));
            found.await();
          } else {
            missed.await();
            device.with(client);
          }
        };
    try (Peer peer = Peer.that(leaving);
        ScriptRun script = new ScriptRun()) {
      script.start(
          """
            modbus_add_signal("127.0.0.1:%d", 1, 5, 2, "s")
            last = False
            while True:
              now = modbus_get_error("s") == 0
              if now != last:
                textmsg(now)
              end
              last = now
              sync()
            end
          """
              .formatted(peer.port()));
      advanceUntil(script, List.of("True"));
      found.countDown();
      advanceUntil(script, List.of("True", "False"));
      missed.countDown();
      advanceUntil(script, List.of("True", "False", "True"));
    }
  }

  private static void advanceUntil(ScriptRun script, List<String> said)
      throws InterruptedException {
    while (!script.said().equals(said)) {
      script.advance();
    }
  }

  /** The error of the connection that a program comes to see. */
  private static void endsIn(int error, Peer.Conversation conversation) throws Exception {
    try (Peer peer = Peer.that(conversation);
        ScriptRun script = new ScriptRun()) {
      assertEquals(
          List.of("goes on"),
          run(
              script,
              peer,
              "  modbus_add_signal(DEVICE, 1, 5, 2, \"s\")\n  until_error(\"s\", "
                  + error
                  + ")\n  textmsg(\"goes on\")\n"));
    }
  }

  private static void stay(Socket client) throws IOException {
    client.getInputStream().transferTo(OutputStream.nullOutputStream());
  }

  @Test
  void aDeviceThatSaysNothingTimesOut() throws Exception {
    endsIn(110, ModbusClientsTest::stay);
  }

  @Test
  void aDeviceThatResetsHasReset() throws Exception {
    endsIn(
        104,
        client -> {
          client.getInputStream().read();
          client.setSoLinger(true, 0);
        });
  }

  @Test
  void aDeviceThatSendsSomethingElseSpeaksNoModbus() throws Exception {
    endsIn(
        71,
        client -> {
          client
              .getOutputStream()
              .write("HTTP/1.1 400 Bad Request\r\n".getBytes(StandardCharsets.US_ASCII));
          stay(client);
        });
  }

  @Test
  void aDeviceThatLiesAboutItsLengthTimesOut() throws Exception {
    endsIn(
        110,
        client -> {
          DataInputStream in = new DataInputStream(client.getInputStream());
          byte[] answer = device(in);
          answer[5] = (byte) 250;
          client.getOutputStream().write(answer);
          stay(client);
        });
  }

  private static byte[] device(DataInputStream in) throws IOException {
    return new FakeDevice().answer(FakeDevice.read(in));
  }

  @Test
  void aDeviceThatAnswersWithTheWrongNumberOfBytesSpeaksNoModbus() throws Exception {
    endsIn(
        71,
        client -> {
          DataInputStream in = new DataInputStream(client.getInputStream());
          byte[] answer = device(in);
          answer[8] = 4;
          client.getOutputStream().write(answer);
          stay(client);
        });
  }

  @Test
  void answersThatComeByteByByteArePutTogether() throws Exception {
    Peer.Conversation cutting =
        client -> {
          DataInputStream in = new DataInputStream(client.getInputStream());
          while (true) {
            for (byte each : device.answer(FakeDevice.read(in))) {
              client.getOutputStream().write(each);
            }
          }
        };
    try (Peer peer = Peer.that(cutting);
        ScriptRun script = new ScriptRun()) {
      run(
          script,
          peer,
          "  modbus_add_signal(DEVICE, 1, 5, 2, \"s\", False, 100)\n  until_valid(\"s\")\n");
    }
  }

  /** A device with a unit that never answers. */
  private Peer deafForUnitTwo() {
    return Peer.that(
        client -> {
          DataInputStream in = new DataInputStream(client.getInputStream());
          while (true) {
            byte[] question = FakeDevice.read(in);
            if (question[6] != 2) {
              client.getOutputStream().write(device.answer(question));
            }
          }
        });
  }

  @Test
  void aSignalWithoutAnAnswerDoesNotStopTheOthers() throws Exception {
    try (Peer peer = deafForUnitTwo();
        ScriptRun script = new ScriptRun()) {
      assertEquals(
          List.of("0"),
          run(
              script,
              peer,
              """
                modbus_add_signal(DEVICE, 1, 5, 2, "good")
                modbus_add_signal(DEVICE, 2, 5, 2, "deaf")
                until_error("deaf", 110)
                textmsg(modbus_get_error("good"))
              """));
    }
  }

  @Test
  void norWhereTheyAreAskedOneByOne() throws Exception {
    try (Peer peer = deafForUnitTwo();
        ScriptRun script = new ScriptRun()) {
      assertEquals(
          List.of("0"),
          run(
              script,
              peer,
              """
                modbus_add_signal(DEVICE, 1, 5, 2, "good", True)
                modbus_add_signal(DEVICE, 2, 5, 2, "deaf", True)
                until_error("deaf", 110)
                textmsg(modbus_get_error("good"))
              """));
      assertEquals(1, peer.clients());
    }
  }

  @Test
  void sequentialDevicesAreAskedOneByOne() throws Exception {
    run(
        """
          modbus_add_signal(DEVICE, 1, 5, 2, "first", True)
          i = 0
          while i < 30:
            modbus_add_signal(DEVICE, 1, i, 2, str_cat("s", i))
            i = i + 1
          end
          i = 0
          while i < 30:
            until_valid(str_cat("s", i))
            i = i + 1
          end
        """);
    assertEquals(0, device.mostWaiting());
  }

  @Test
  void aDeviceThatTakesOneQuestionAtATimeIsAskedOneByOneOnceThatIsKnown() throws Exception {
    AtomicInteger connections = new AtomicInteger();
    Peer.Conversation firstOnly =
        client -> {
          DataInputStream in = new DataInputStream(client.getInputStream());
          if (connections.incrementAndGet() == 1) {
            byte[] first = FakeDevice.read(in);
            FakeDevice.read(in);
            client.getOutputStream().write(device.answer(first));
            stay(client);
          }
          device.with(client);
        };
    try (Peer peer = Peer.that(firstOnly);
        ScriptRun script = new ScriptRun()) {
      run(
          script,
          peer,
          """
            modbus_add_signal(DEVICE, 1, 5, 2, "a")
            modbus_add_signal(DEVICE, 1, 6, 2, "b")
            modbus_add_signal(DEVICE, 1, 7, 2, "c")
            until_valid("a")
            until_valid("b")
            until_valid("c")
          """);
      assertEquals(2, peer.clients());
      assertEquals(0, device.mostWaiting());
    }
  }

  @Test
  void manyDevicesWithManySignalsAreAllRead() throws Exception {
    try (Peer first = Peer.that(device);
        Peer second = Peer.that(device);
        ScriptRun script = new ScriptRun()) {
      run(
          script,
          first,
          """
            i = 0
            while i < 60:
              modbus_add_signal(DEVICE, 1, i, 2, str_cat("a", i))
              modbus_add_signal("127.0.0.1:%d", 1, i, 2, str_cat("b", i))
              i = i + 1
            end
            i = 0
            while i < 60:
              until_valid(str_cat("a", i))
              until_valid(str_cat("b", i))
              i = i + 1
            end
          """
              .replace("%d", "" + second.port()));
      assertEquals(1, first.clients());
      assertEquals(1, second.clients());
    }
  }

  @Test
  void resettingMakesANewConnection() throws Exception {
    try (Peer peer = Peer.that(device);
        ScriptRun script = new ScriptRun()) {
      run(
          script,
          peer,
          """
            modbus_add_signal(DEVICE, 1, 5, 2, "s")
            until_valid("s")
            modbus_reset_connection(DEVICE)
            textmsg(modbus_get_error("s"))
          """);
      assertEquals(List.of("0"), script.said());
      assertEquals(2, peer.clients());
    }
  }

  @Test
  void aCommandOfTheProgramsOwnIsSentAndItsAnswerDropped() throws Exception {
    run("  modbus_send_custom_command(DEVICE, 103, 6, [0, 32, 2, 88])\n");
    assertEquals(List.of("103 6 32 600"), device.asked());
    assertEquals(600, device.register(32));
  }

  @Test
  void aCommandToNobodyEndsTheProgram() throws Exception {
    try (ScriptRun script = new ScriptRun(AllowedHosts.parse("none"))) {
      script.run("  modbus_send_custom_command(\"127.0.0.1:9\", 1, 6, [])\n");
      assertTrue(
          script
              .reported()
              .getLast()
              .endsWith("modbus_send_custom_command: 127.0.0.1:9: not among the allowed hosts"),
          () -> script.reported().getLast());
    }
  }

  @Test
  void aHostThatIsNotAllowedIsNeverContacted() throws Exception {
    CountDownLatch contacted = new CountDownLatch(1);
    try (Peer peer = Peer.that(client -> contacted.countDown());
        ScriptRun script = new ScriptRun(AllowedHosts.parse("10.0.0.0/8"))) {
      run(script, peer, "  modbus_add_signal(DEVICE, 1, 5, 2, \"s\")\n  until_error(\"s\", 13)\n");
      assertEquals(1, contacted.getCount());
    }
  }

  @Test
  void aPortWhereNobodyListensRefuses() throws Exception {
    try (ClosedPort closed = new ClosedPort();
        ScriptRun script = new ScriptRun()) {
      script.run(
          UNTIL_VALID
              + "  modbus_add_signal(\"127.0.0.1:"
              + closed.number()
              + "\", 1, 5, 2, \"s\")\n  until_error(\"s\", 111)\n");
    }
  }

  @Test
  void deletingTheLastSignalClosesTheConnection() throws Exception {
    CountDownLatch closed = new CountDownLatch(1);
    Peer.Conversation telling =
        client -> {
          try {
            device.with(client);
          } finally {
            closed.countDown();
          }
        };
    try (Peer peer = Peer.that(telling);
        ScriptRun script = new ScriptRun()) {
      run(
          script,
          peer,
          """
            modbus_add_signal(DEVICE, 1, 5, 2, "s")
            until_valid("s")
            modbus_add_signal(DEVICE, 1, 6, 2, "s")
            until_valid("s")
            modbus_delete_signal("s")
          """);
      closed.await();
      assertEquals(1, peer.clients());
    }
  }
}
