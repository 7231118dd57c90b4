package org.pendant.protocols.eip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.InstallationCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.eip.AssemblyCommand;
import org.pendant.controller.eip.AssemblyPair;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.rtde.ControlAssembly;
import org.pendant.controller.state.StateStream;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

@Tag("slow")
class EipServerTest {
  private static final int RPI_US = 20_000;
  private static final int MOST_READS = 2_000;
  private static final String GET_STATE = "0E 03 2004 2464 3003";

  private final RunningBox box =
      new RunningBox(ControllerOptions.headless(), RemoteControl.disabled());
  private EipServer server;
  private int port;

  @BeforeEach
  void open() throws IOException {
    server = EipServer.open(box.serverContext(), PortNumbers.anyFree());
    port = server.ports().getFirst().number();
  }

  @AfterEach
  void close() {
    server.close();
    box.close();
  }

  private Reply ask(Command command) throws Exception {
    return box.controller().submit(command).get(RunningBox.GIVE_UP_MS, TimeUnit.MILLISECONDS);
  }

  private int integer(int register) {
    return box.controller().state().signals().registers(RegisterDirection.INPUT).integer(register);
  }

  private static byte[] control(int register0) {
    return ByteBuffer.allocate(ControlAssembly.BYTES)
        .order(ByteOrder.LITTLE_ENDIAN)
        .putInt(28, register0)
        .array();
  }

  private static String builtIn(Scanner scanner) {
    return scanner.request(RPI_US, 112, ControlAssembly.BYTES, 100, StateAssembly.BYTES);
  }

  private static int refused(ConnectionFault fault) {
    return CipRefusal.CONNECTION << 16 | fault.code();
  }

  @Test
  void tellsWhoItIsByTcpAndUdp() throws IOException {
    try (EipClient client = new EipClient(port);
        DatagramSocket socket = new DatagramSocket()) {
      String tcp = Hex.text(client.ask(Encapsulation.LIST_IDENTITY, "").data());
      assertTrue(tcp.startsWith("01000C0032000100" + "0002AF127F000001"), tcp);
      assertTrue(tcp.endsWith("10556E6976657273616C20526F626F747303"), tcp);
      socket.setSoTimeout(RunningBox.GIVE_UP_MS);
      send(socket, question(Encapsulation.LIST_IDENTITY));
      assertEquals(
          tcp, Hex.text(EncapsulationFrame.decode(ByteBuffer.wrap(receive(socket))).data()));
    }
  }

  @Test
  void answersNoAnswersByUdp() throws IOException {
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(RunningBox.GIVE_UP_MS);
      byte[] question = question(Encapsulation.LIST_IDENTITY);
      send(socket, question);
      byte[] identity = receive(socket);
      send(socket, identity);
      // Datagrams on one machine keep their order: had the one above been answered, that came
      // first.
      send(socket, question(Encapsulation.LIST_INTERFACES));
      assertEquals(
          Encapsulation.LIST_INTERFACES,
          EncapsulationFrame.decode(ByteBuffer.wrap(receive(socket))).command());
    }
  }

  private static byte[] question(int command) {
    return new EncapsulationFrame(command, 0, 0, 5, 0, Hex.buffer("")).encode();
  }

  private void send(DatagramSocket socket, byte[] bytes) throws IOException {
    socket.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port));
  }

  private static byte[] receive(DatagramSocket socket) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[500], 500);
    socket.receive(packet);
    return Arrays.copyOf(packet.getData(), packet.getLength());
  }

  @Test
  void answersNoAnswersByTcp() throws IOException {
    try (EipClient client = new EipClient(port)) {
      client.send(
          new EncapsulationFrame(Encapsulation.LIST_SERVICES, 0, 1, 5, 0, Hex.buffer("")).encode());
      assertEquals(
          Encapsulation.LIST_INTERFACES, client.ask(Encapsulation.LIST_INTERFACES, "").command());
    }
  }

  @Test
  void listsServicesAndNoInterfaces() throws IOException {
    try (EipClient client = new EipClient(port)) {
      assertEquals(
          "0100 0001 1400 0100 2001 436F6D6D756E69636174696F6E730000".replace(" ", ""),
          Hex.text(client.ask(Encapsulation.LIST_SERVICES, "").data()));
      assertEquals("0000", Hex.text(client.ask(Encapsulation.LIST_INTERFACES, "").data()));
      assertEquals(Encapsulation.UNKNOWN_COMMAND, client.ask(0x77, "").status());
    }
  }

  @Test
  void onlyASessionMaySendMessages() throws IOException {
    try (EipClient client = new EipClient(port)) {
      assertEquals(
          Encapsulation.BAD_SESSION, client.ask(Encapsulation.SEND_RR_DATA, "00").status());
      assertEquals(
          Encapsulation.BAD_VERSION,
          client.ask(Encapsulation.REGISTER_SESSION, "0200 0000").status());
      assertEquals(
          Encapsulation.BAD_LENGTH, client.ask(Encapsulation.REGISTER_SESSION, "0100").status());
    }
    try (EipClient client = EipClient.registered(port)) {
      assertEquals(
          Encapsulation.BAD_DATA,
          client.ask(Encapsulation.SEND_RR_DATA, "00000000 0000 0100").status());
      client.send(
          new EncapsulationFrame(Encapsulation.UNREGISTER_SESSION, 0, 0, 0, 0, Hex.buffer(""))
              .encode());
      assertTrue(client.ended());
    }
  }

  @Test
  void aLostScannerStopsTheProgramWhereTheInstallationSaysSo() throws Exception {
    assertInstanceOf(
        Reply.Done.class,
        ask(
            new InstallationCommand.ApplyInstallation(
                InstallationText.read("pendant installation 1\nethernet-ip on-loss=stop\n")
                    .installation())));
    Program waits = TestController.program(box.controller(), "def waits():\n  sleep(1e9)\nend\n");
    assertInstanceOf(Reply.Done.class, ask(new ProgramCommand.StartProgram(waits)));
    try (EipClient client = EipClient.registered(port);
        Scanner scanner = new Scanner(client, 1);
        StateStream.Subscription frames = box.controller().feed().follow()) {
      assertEquals(0, scanner.open(builtIn(scanner).replace("CDAB000005", "CDAB000000")));
      scanner.run(control(9));
      while (box.controller().state().program().state() != ProgramState.STOPPED) {
        var _ = frames.take();
      }
    }
    assertTrue(
        box.controller().logSince(0).stream().anyMatch(each -> each.code().equals("C207A0")));
  }

  @ParameterizedTest
  @CsvSource({
    "0E 03 2001 2401 3001, 8E000000 7705",
    "0E 03 2001 2401 3007, 8E000000 10556E6976657273616C20526F626F7473",
    "01 02 2001 2401, 81000000 7705 2B00 0100 0518 3000 00552220"
        + " 10556E6976657273616C20526F626F7473",
    "0E 03 2001 2400 3001, 8E000000 0100",
    "0E 03 2004 2470 3004, 8E000000 E000",
    "0E 03 2004 2401 3003, 8E000000",
    "0E 03 20F6 2401 3003, 8E000000 025552000001",
    "0E 03 20F5 2401 3005, 8E000000 0100007F 000000FF 00000000 00000000 00000000 0000",
    "0E 03 2001 2401 3009, 8E001400",
    "0E 03 2001 2402 3001, 8E001600",
    "0E 03 2099 2401 3001, 8E000500",
    "4C 03 2001 2401 3001, CC000800",
    "10 03 2001 2401 3001 0000, 90000E00",
    "10 03 2004 2470 3003 00, 90000E00",
    "0E 09 2001, 8E000400",
    "52 02 2006 2401 0A 0E 0800 0E03200124013001 0100 0100, 8E000000 7705",
    "52 02 2006 2401 0A 0E FF00 0E03, D2001300"
  })
  void answersMessages(String message, String answer) throws IOException {
    try (EipClient client = EipClient.registered(port)) {
      assertEquals(answer.replace(" ", ""), client.message(message));
    }
  }

  @Test
  void theStateCanBeReadByMessages() throws Exception {
    ask(
        new IoCommand.WriteSignals(
            "test",
            List.of(new SignalWrite.IntegerRegister(RegisterDirection.OUTPUT, 1, 0x01020304))));
    try (EipClient client = EipClient.registered(port)) {
      String answer = client.message(GET_STATE);
      assertEquals(2 * (4 + 480), answer.length());
      assertEquals("04030201", answer.substring(2 * (4 + 292), 2 * (4 + 296)));
    }
  }

  @Test
  void messagesGoByAConnectionToo() throws IOException {
    try (EipClient client = EipClient.registered(port)) {
      String opened =
          client.message(
              "5B 02 2006 2401 0A 0E 00000000 78563412 2A00 3412 CDAB0000 07 000000"
                  + " 80841E00 A00F0042 80841E00 A00F0042 A3 03 0100 2002 2401");
      assertEquals("DB000000", opened.substring(0, 8));
      String id = opened.substring(8, 16);
      EncapsulationFrame answer =
          client.ask(
              Encapsulation.SEND_UNIT_DATA,
              "00000000 0000 0200 A100 0400 " + id + " B100 0A00 0700 0E03200124013001");
      assertEquals(
          "00000000 0000 0200 A100 0400 78563412 B100 0800 0700 8E000000 7705".replace(" ", ""),
          Hex.text(answer.data()));
      assertEquals(
          "CE000000 2A00 3412 CDAB0000 0000".replace(" ", ""),
          client.message("4E 02 2006 2401 0A 0E 2A00 3412 CDAB0000 02 00 2002 2401"));
    }
  }

  @Test
  void cyclicDataGoBothWaysWithoutLoss() throws Exception {
    try (EipClient client = EipClient.registered(port);
        Scanner scanner = new Scanner(client, 1)) {
      assertEquals(0, scanner.open(builtIn(scanner)));
      for (int i = 1; i <= 100; i++) {
        IoPacket packet = scanner.receive();
        assertEquals(scanner.toScannerId(), packet.connection());
        assertEquals(i, packet.number());
        assertEquals(StateAssembly.BYTES, packet.data().remaining());
        scanner.run(control(i));
      }
      while (integer(0) < 100) {
        scanner.receive();
      }
      assertEquals(100, integer(0));
      assertEquals("8E00000061", client.message("0E 03 2001 2401 3005").substring(0, 10));
      assertEquals(0, scanner.forwardClose());
      assertEquals("8E00000030", client.message("0E 03 2001 2401 3005").substring(0, 10));
      assertEquals(CipRefusal.CONNECTION, scanner.forwardClose());
    }
  }

  @Test
  void anIdleScannerChangesNothing() throws Exception {
    try (EipClient client = EipClient.registered(port);
        Scanner scanner = new Scanner(client, 1)) {
      assertEquals(0, scanner.open(builtIn(scanner)));
      scanner.idle(control(5));
      scanner.run(control(6));
      while (integer(0) == 0) {
        scanner.receive();
      }
      assertEquals(6, integer(0));
      scanner.idle(control(7));
      for (int i = 0; i < 5; i++) {
        scanner.receive();
        scanner.idle(control(8 + i));
      }
      assertEquals(6, integer(0));
    }
  }

  @Test
  void oneScannerOwnsWhatItWrites() throws Exception {
    try (EipClient client = EipClient.registered(port);
        Scanner first = new Scanner(client, 1);
        Scanner second = new Scanner(client, 2)) {
      assertEquals(0, first.open(builtIn(first)));
      assertEquals(refused(ConnectionFault.DUPLICATE), first.open(builtIn(first)));
      assertEquals(refused(ConnectionFault.OWNERSHIP), second.open(builtIn(second)));
      Reply.Refused refused =
          assertInstanceOf(
              Reply.Refused.class,
              ask(new IoCommand.ClaimSignal("RTDE client", "input_integer_register[0]")));
      assertTrue(refused.toString().contains("EtherNet/IP scanner 127.0.0.1"), refused::toString);
      assertEquals(0, first.forwardClose());
      assertEquals(
          new Reply.Done(),
          ask(new IoCommand.ClaimSignal("RTDE client", "input_integer_register[0]")));
      assertEquals(refused(ConnectionFault.OWNERSHIP), second.open(builtIn(second)));
      ask(new IoCommand.ReleaseSignals("RTDE client"));
      assertEquals(0, second.open(builtIn(second)));
    }
  }

  @Test
  void whatAPlcOfTheCellWritesIsOwned() throws Exception {
    RunningBox withPlc =
        new RunningBox(
            ControllerOptions.headless()
                .withEquipment(
                    new CellEquipment(
                        List.of(new DeviceSetup.EthernetIp("plc", 0.01, Map.of())), List.of())),
            RemoteControl.disabled());
    try (EipServer beside = EipServer.open(withPlc.serverContext(), PortNumbers.anyFree());
        EipClient client = EipClient.registered(beside.ports().getFirst().number());
        Scanner scanner = new Scanner(client, 1)) {
      var _ =
          withPlc
              .controller()
              .submit(new IoCommand.ReleaseSignals("nobody"))
              .get(RunningBox.GIVE_UP_MS, TimeUnit.MILLISECONDS);
      assertEquals(refused(ConnectionFault.OWNERSHIP), scanner.open(builtIn(scanner)));
      assertTrue(client.message(GET_STATE).startsWith("8E000000"), "anybody may read");
    } finally {
      withPlc.close();
    }
  }

  @Test
  void anExplicitReadShowsWhatWasWrittenLastByAPlcOfTheCellOrByAScanner() throws Exception {
    RunningBox withPlc =
        new RunningBox(
            ControllerOptions.headless()
                .withEquipment(
                    new CellEquipment(
                        List.of(new DeviceSetup.EthernetIp("plc", 0.002, Map.of())), List.of())),
            RemoteControl.disabled());
    try (EipServer beside = EipServer.open(withPlc.serverContext(), PortNumbers.anyFree());
        EipClient client = EipClient.registered(beside.ports().getFirst().number());
        Scanner scanner = new Scanner(client, 1)) {
      set(withPlc, "plc.input_integer_register[0]", 5);
      assertEquals("8E000000" + Hex.text(ByteBuffer.wrap(control(5))), controlRead(client, 5));
      set(withPlc, "plc.online", 0);
      int status = refused(ConnectionFault.OWNERSHIP);
      while (status == refused(ConnectionFault.OWNERSHIP)) {
        // until the signals are given back
        status = scanner.open(builtIn(scanner));
      }
      assertEquals(0, status);
      assertEquals("8E000000" + Hex.text(ByteBuffer.wrap(control(5))), controlRead(client, 5));
      scanner.run(control(9));
      assertEquals("8E000000" + Hex.text(ByteBuffer.wrap(control(9))), controlRead(client, 9));
    } finally {
      withPlc.close();
    }
  }

  private static void set(RunningBox at, String signal, int value) throws Exception {
    var _ =
        at.controller()
            .submit(new WorldCommand.SetSignal(signal, value))
            .get(RunningBox.GIVE_UP_MS, TimeUnit.MILLISECONDS);
  }

  /** Instance 112 as an explicit message reads it, as soon as it has a number in register 0. */
  private static String controlRead(EipClient client, int register0) throws IOException {
    String has =
        Hex.text(ByteBuffer.allocate(4).order(ByteOrder.LITTLE_ENDIAN).putInt(0, register0));
    String read = "";
    for (int i = 0; i < MOST_READS && !read.startsWith(has, 8 + 2 * 28); i++) {
      read = client.message("0E 03 2004 2470 3003");
    }
    return read;
  }

  @Test
  void aSilentScannerLosesItsConnectionAndItsDataStay() throws Exception {
    try (EipClient client = EipClient.registered(port);
        Scanner scanner = new Scanner(client, 1);
        Scanner next = new Scanner(client, 2)) {
      String impatient = builtIn(scanner).replace("CDAB000005", "CDAB000000");
      assertEquals(0, scanner.open(impatient));
      assertTrue(box.nextLogged().endsWith("writes instance 112 and reads 100"));
      scanner.run(control(9));
      String line = box.nextLogged();
      assertTrue(line.endsWith("timed out: what it has written stays"), line);
      assertEquals(9, integer(0));
      int status = refused(ConnectionFault.OWNERSHIP);
      while (status == refused(ConnectionFault.OWNERSHIP)) {
        // until the signals are given back
        status = next.open(builtIn(next));
      }
      assertEquals(0, status);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "20000, 112, 223, 100, 480, SIZE_TO_TARGET",
    "20000, 112, 224, 100, 481, SIZE_TO_ORIGINATOR",
    "20000, 100, 480, 112, 224, PATH",
    "20000, 111, 16, 100, 480, PATH",
    "1999, 112, 224, 100, 480, RPI",
    "10000001, 112, 224, 100, 480, RPI"
  })
  void refusesConnectionsThatCannotBe(
      int us, int from, int fromBytes, int to, int toBytes, ConnectionFault fault)
      throws IOException {
    try (EipClient client = EipClient.registered(port);
        Scanner scanner = new Scanner(client, 1)) {
      assertEquals(refused(fault), scanner.open(scanner.request(us, from, fromBytes, to, toBytes)));
    }
  }

  @ParameterizedTest
  @CsvSource({
    "E648, E628, TYPE",
    "E648, E64A, VARIABLE_SIZE_TO_TARGET",
    "E249, E24B, VARIABLE_SIZE_TO_ORIGINATOR",
    "01042004, 21042004, TRANSPORT",
    "24012C, 24022C, PATH"
  })
  void refusesOtherKindsOfConnections(String part, String other, ConnectionFault fault)
      throws IOException {
    try (EipClient client = EipClient.registered(port);
        Scanner scanner = new Scanner(client, 1)) {
      String right = builtIn(scanner);
      assertTrue(right.contains(part), right);
      assertEquals(refused(fault), scanner.open(right.replace(part, other)));
    }
  }

  @Test
  void refusesAScannerThatExpectsAnotherDevice() throws IOException {
    try (EipClient client = EipClient.registered(port);
        Scanner scanner = new Scanner(client, 1)) {
      String keyed =
          builtIn(scanner).replace("0104200424012C70", "01093404010000000000" + "0000200424012C70");
      assertEquals(refused(ConnectionFault.WRONG_VENDOR_OR_PRODUCT), scanner.open(keyed));
    }
  }

  @Test
  void configuredAssembliesAreExchanged() throws Exception {
    ask(new AssemblyCommand.ConfigureAssemblies(new AssemblyPair(101, 8, 111, 4)));
    try (EipClient client = EipClient.registered(port);
        Scanner scanner = new Scanner(client, 1)) {
      assertEquals(0, scanner.open(scanner.request(RPI_US, 111, 4, 101, 8)));
      assertEquals("0000000000000000", Hex.text(scanner.receive().data()));
      scanner.run(Hex.bytes("01020304"));
      String wanted = "8E00000001020304";
      while (!client.message("0E 03 2004 246F 3003").equals(wanted)) {
        scanner.receive();
      }
      assertEquals(
          Hex.text(Hex.bytes("01020304")),
          Hex.text(box.controller().state().assemblies().fromPlc(111).orElseThrow().toArray()));
    }
  }
}
