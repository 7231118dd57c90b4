package org.pendant.protocols.rtde;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.WallClock;
import org.pendant.controller.rtde.OutputField;
import org.pendant.controller.rtde.OutputFields;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.SoftwareVersion;
import org.pendant.controller.state.StateStream;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;

@Tag("slow")
class RtdeServerTest {
  private static final int MAX_FRAMES = 5000;

  private final BlockingQueue<String> logged = new LinkedBlockingQueue<>();
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final FrameLoop loop = FrameLoop.start(controller, new WallClock());
  private final PeerLog log = new PeerLog((level, text) -> logged.add(text));
  private final StateBroadcaster frames = new StateBroadcaster(controller.feed(), log);
  private final RtdeServer server = open();

  private RtdeServer open() {
    try {
      return RtdeServer.open(
          new ServerContext(controller, frames, log, RemoteControl.disabled()),
          PortNumbers.anyFree());
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @AfterEach
  void close() {
    server.close();
    frames.close();
    loop.close();
  }

  private int port() {
    return server.ports().getFirst().number();
  }

  private Client client() throws IOException {
    return Client.speaking2(port());
  }

  private ControllerState await(Predicate<ControllerState> wanted) throws InterruptedException {
    try (StateStream.Subscription follower = controller.feed().follow()) {
      for (int i = 0; i < MAX_FRAMES; i++) {
        ControllerState state = follower.take();
        if (wanted.test(state)) {
          return state;
        }
      }
    }
    throw new AssertionError("did not come within " + MAX_FRAMES + " frames");
  }

  private static byte[] integer(int recipe, int value) {
    return ByteBuffer.allocate(5).put((byte) recipe).putInt(value).array();
  }

  private void awaitInteger(int address, int value) throws InterruptedException {
    await(state -> state.signals().inputs().integer(address) == value);
  }

  @Test
  void speaksVersionsOneAndTwo() throws Exception {
    try (Client client = new Client(port())) {
      for (int version = 0; version < 5; version++) {
        client.send('V', new byte[] {0, (byte) version});
        assertEquals(version == 1 || version == 2 ? "V 01" : "V 00", client.answer());
      }
      client.send('v');
      ByteBuffer numbers = client.next().payload();
      assertEquals(SoftwareVersion.REPORTED.major(), numbers.getInt());
      assertEquals(SoftwareVersion.REPORTED.minor(), numbers.getInt());
      assertEquals(SoftwareVersion.REPORTED.bugfix(), numbers.getInt());
    }
  }

  @Test
  void sendsEveryFrameAtFiveHundredHertz() throws Exception {
    try (Client client = client()) {
      assertEquals("1 DOUBLE,VECTOR6D", client.outputs(500, "timestamp,actual_q"));
      client.send('S');
      assertEquals("S 01", client.answer());
      double before = 0;
      for (int i = 0; i < 100; i++) {
        Packet packet = client.next();
        assertEquals('U', packet.type());
        assertEquals(1 + 8 + 48, packet.payload().remaining());
        assertEquals(1, packet.payload().get());
        double timeS = packet.payload().getDouble();
        assertEquals(
            controller.state().arm().actualPositionRad().get(0),
            packet.payload().getDouble(),
            1e-3);
        if (i > 0) {
          assertEquals(before + 0.002, timeS, 1e-9);
        }
        before = timeS;
      }
    }
  }

  @Test
  void sendsLessOftenWhenAskedTo() throws Exception {
    try (Client client = client()) {
      client.outputs(125, "timestamp,");
      client.send('S');
      client.next();
      double first = client.next().payload().getDouble(1);
      assertEquals(first + 0.008, client.next().payload().getDouble(1), 1e-9);
      assertEquals(first + 0.016, client.next().payload().getDouble(1), 1e-9);
    }
  }

  @Test
  void versionOneHasNoNumbers() throws Exception {
    try (Client client = new Client(port())) {
      client.send('O', "timestamp,robot_mode".getBytes(StandardCharsets.US_ASCII));
      assertEquals("O 444f55424c452c494e543332", client.answer());
      client.send('S');
      assertEquals("S 01", client.answer());
      Packet data = client.next();
      assertEquals(8 + 4, data.payload().remaining());
      assertEquals(7, data.payload().getInt(8));
    }
  }

  @Test
  void pausesAndStartsAgain() throws Exception {
    try (Client client = client()) {
      client.outputs(500, "timestamp");
      client.send('S');
      client.next();
      client.next();
      client.send('P');
      Packet packet = client.next();
      while (packet.type() == 'U') {
        packet = client.next();
      }
      assertEquals('P', packet.type());
      client.send('P');
      assertEquals("P 01", client.answer());
      // frames go by, and none is sent
      long frame = controller.state().frame();
      await(state -> state.frame() > frame + 20);
      client.send('S');
      assertEquals("S 01", client.answer());
      assertEquals('U', client.next().type());
    }
  }

  @Test
  void anOutputThatIsNotThereMakesTheRecipeUnusable() throws Exception {
    try (Client client = client()) {
      client.send('S');
      assertEquals("S 00", client.answer());
      assertEquals("0 DOUBLE,NOT_FOUND", client.outputs(125, "timestamp,nonsense"));
      client.send('S');
      assertEquals("S 00", client.answer());
      assertEquals("0 DOUBLE", client.outputs(Double.NaN, "timestamp"));
      client.send('S');
      assertEquals("S 00", client.answer());
      assertEquals("1 DOUBLE", client.outputs(9999, "timestamp"));
      client.send('S');
      assertEquals("S 01", client.answer());
    }
  }

  @Test
  void aClientMayAskForAllOutputsTogether() throws Exception {
    String names = String.join(",", OutputFields.all().stream().map(OutputField::name).toList());
    int bytes = OutputFields.all().stream().mapToInt(each -> each.type().bytes()).sum();
    try (Client client = client()) {
      String types = client.outputs(500, names);
      assertTrue(types.startsWith("1 "), types);
      assertEquals(OutputFields.all().size(), types.split(",").length);
      client.send('S');
      assertEquals("S 01", client.answer());
      assertEquals(1 + bytes, client.next().payload().remaining());
    }
  }

  @Test
  void aRecipeWhoseDataNoPackageCanHoldIsAnsweredAndCannotBeStarted() throws Exception {
    String names = "actual_q,".repeat(1500);
    try (Client client = client()) {
      assertEquals("0 " + "VECTOR6D,".repeat(1499) + "VECTOR6D", client.outputs(500, names));
      assertEquals(
          "a data package of the recipe would take 72004 bytes, must be at most 65535",
          client.text());
      client.send('S');
      assertEquals("S 00", client.answer());
      assertEquals("1 DOUBLE", client.outputs(500, "timestamp"));
    }
  }

  @Test
  void aRecipeWhoseTypesNoPackageCanHoldIsAnsweredWithoutThem() throws Exception {
    String names = "a,".repeat(8000);
    String text = "the types of a recipe of 8000 variables take 80003 bytes, must be at most 65535";
    try (Client client = client()) {
      assertEquals("0 ", client.outputs(500, names));
      assertEquals(text, client.text());
      assertEquals("0 ", client.inputs(names));
      assertEquals(text, client.text());
    }
  }

  @Test
  void aRecipeOfTooManyNamesIsAnsweredAndTheConnectionGoesOn() throws Exception {
    String names = "timestamp,".repeat(1639);
    try (Client client = client()) {
      assertEquals("1 DOUBLE", client.outputs(500, "timestamp"));
      assertEquals("0 ", client.outputs(500, names));
      String text = "the names of a recipe take 16390 bytes, must be at most 16384";
      assertEquals(text, client.text());
      client.send('S');
      assertEquals("S 00", client.answer());
      assertEquals("0 ", client.inputs(names));
      assertEquals(text, client.text());
      assertEquals("1 INT32", client.inputs("input_int_register_0"));
    }
  }

  @Test
  void aSecondOutputRecipeTakesThePlaceOfTheFirst() throws Exception {
    try (Client client = client()) {
      client.outputs(500, "timestamp");
      assertEquals("1 INT32", client.outputs(500, "robot_mode"));
      client.send('S');
      client.next();
      assertEquals("U 0100000007", client.answer());
    }
  }

  @Test
  void inputsAreWrittenAndStayWhenTheClientGoes() throws Exception {
    try (Client client = client()) {
      assertEquals("1 INT32", client.inputs("input_int_register_24"));
      client.send('U', integer(1, 4711));
      awaitInteger(24, 4711);
    }
    try (Client next = client()) {
      while (next.inputs("input_int_register_24").startsWith("0")) {
        // the server is about to notice that the other one has gone
      }
      assertEquals(4711, controller.state().signals().inputs().integer(24));
    }
  }

  @Test
  void recipesOfOneConnectionShareInputsAndHaveNumbersInTheirOrder() throws Exception {
    try (Client client = client()) {
      assertEquals("1 INT32", client.inputs("input_int_register_24,"));
      for (int id = 2; id <= 30; id++) {
        String types = client.inputs("input_int_register_24,input_double_register_" + id + ",");
        assertEquals(id + " INT32,DOUBLE", types);
      }
      client.send('U', ByteBuffer.allocate(13).put((byte) 30).putInt(7).putDouble(0.5).array());
      awaitInteger(24, 7);
      assertEquals(0.5, controller.state().signals().inputs().floating(30));
      client.send('U', integer(1, 8));
      awaitInteger(24, 8);
    }
  }

  @Test
  void anInputBelongsToTheConnectionThatAskedFirst() throws Exception {
    try (Client one = client();
        Client two = client()) {
      assertEquals("1 UINT32,DOUBLE", one.inputs("speed_slider_mask,speed_slider_fraction"));
      assertEquals("0 IN_USE,INT32", two.inputs("speed_slider_fraction,input_int_register_0"));
      assertEquals("0 NOT_FOUND,INT32", two.inputs("speed,input_int_register_0"));
      assertEquals("1 INT32", two.inputs("input_int_register_0"));
      two.send('U', integer(1, 5));
      awaitInteger(0, 5);
    }
  }

  @Test
  void inputsOfAConnectionThatHasJustBeenClosedCanBeTakenAtOnce() throws Exception {
    for (int i = 0; i < 100; i++) {
      try (Client client = client()) {
        assertEquals("1 INT32", client.inputs("input_int_register_0"));
      }
    }
  }

  @Test
  void oneConnectionHasAtMost255InputRecipes() throws Exception {
    try (Client client = client()) {
      for (int id = 1; id < 255; id++) {
        client.inputs("input_int_register_0");
      }
      client.send('I', "input_int_register_0".getBytes(StandardCharsets.US_ASCII));
      assertEquals((byte) 255, client.next().payload().get());
      assertEquals("0 INT32", client.inputs("input_int_register_0"));
      assertEquals("a connection has 255 input recipes, which is the most", client.text());
    }
  }

  @Test
  void whatCannotBeWrittenIsSaidAndTheConnectionGoesOn() throws Exception {
    try (Client client = client()) {
      client.send('U', integer(1, 5));
      assertEquals("there is no input recipe 1", client.text());
      client.inputs("input_int_register_0");
      client.send('U', new byte[] {1, 0, 0});
      assertEquals("the values of input recipe 1 take 2 bytes, must be 4", client.text());
      client.send('U', new byte[] {0, 0, 0, 0, 0});
      assertEquals("there is no input recipe 0", client.text());
      client.send('Q');
      assertEquals("a package has type 81, which is not known", client.text());
      client.send('U', integer(1, 6));
      awaitInteger(0, 6);
    }
  }

  @Test
  void aValueThatCannotBeIsSaidOnce() throws Exception {
    try (Client client = client()) {
      client.inputs("speed_slider_mask,speed_slider_fraction");
      byte[] wrong = ByteBuffer.allocate(13).put((byte) 1).putInt(1).putDouble(7).array();
      for (int i = 0; i < 100; i++) {
        client.send('U', wrong);
      }
      client.send('U', ByteBuffer.allocate(13).put((byte) 1).putInt(1).putDouble(0.5).array());
      client.send('U', wrong);
      String text = "speed_slider_fraction is 7.0, must be 0 to 1";
      assertEquals(text, client.text());
      assertEquals(text, client.text());
      client.send('v');
      assertEquals('v', client.next().type());
      await(state -> state.arm().speedFraction() == 0.5);
    }
  }

  @Test
  void textsOfClientsAreLogged() throws Exception {
    try (Client client = client()) {
      client.send('M', new byte[] {2, 'H', 'i', 2, 'm', 'e', 2});
      String line = logged.poll(20, TimeUnit.SECONDS);
      assertTrue(line.startsWith("RTDE client 127.0.0.1:"), line);
      assertTrue(line.endsWith(" says: me: Hi"), line);
    }
  }

  @Test
  void aPackageWithoutSizeEndsTheConnection() throws Exception {
    try (Client client = client()) {
      client.send('V', new byte[] {0, 2});
      client.next();
      client.sendRaw(new byte[] {0, 2, 'V'});
      assertTrue(client.ended());
      String line = logged.poll(20, TimeUnit.SECONDS);
      assertTrue(
          line.endsWith("was disconnected: the size of a package is 2, must be at least 3"), line);
    }
  }

  @Test
  void packagesThatComeTogetherAreWrittenInTheirOrder() throws Exception {
    try (Client client = client()) {
      client.inputs("input_int_register_1");
      for (int i = 1; i <= 2000; i++) {
        client.send('U', integer(1, i));
      }
      awaitInteger(1, 2000);
      assertEquals(List.of(), List.copyOf(logged));
    }
  }
}
