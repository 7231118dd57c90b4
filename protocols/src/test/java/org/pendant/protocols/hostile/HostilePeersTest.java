package org.pendant.protocols.hostile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.WallClock;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.message.Operator;
import org.pendant.controller.quantity.PortImage;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.BoxPorts;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.robotapi.RobotApiServer;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.teachpendant.PendantSetup;
import org.pendant.protocols.teachpendant.RemotePendant;

/** Clients that break every protocol. {@code -Dtest.cases=5} or more for a thorough run. */
@Tag("slow")
@Isolated("the memory of the whole JVM is measured")
class HostilePeersTest {
  private static final long SEED = 20_261_122;
  private static final int PACKETS = 8_000 * Integer.getInteger("test.cases", 1);
  private static final int PEERS_A_PORT = 10;
  private static final int AT_ONCE = 32;
  private static final int GIVE_UP_S = 60;
  private static final int GIVE_UP_MS = GIVE_UP_S * 1000;
  private static final long MORE_MEMORY = 48L << 20;

  private final Controller controller =
      new Controller(ControllerOptions.headless().withOperator(Operator.present()));
  private final AtomicLong logged = new AtomicLong();
  private final BlockingQueue<String> faults = new LinkedBlockingQueue<>();
  private final long beganNs = System.nanoTime();
  private final PeerLog log =
      new PeerLog(
          (level, text) -> {
            logged.incrementAndGet();
            if (text.contains("internal error")) {
              faults.add(text);
            }
          });
  private final StateBroadcaster frames = new StateBroadcaster(controller.feed(), log);
  private FrameLoop loop;
  private BoxPorts ports;

  @TempDir Path folder;

  @BeforeEach
  void open() throws IOException {
    loop = FrameLoop.start(controller, new WallClock());
    ports =
        BoxPorts.open(
            new ServerContext(controller, frames, log, RemoteControl.disabled()),
            PortNumbers.anyFree().with(RobotApiServer.STANDARD_PORT, 0),
            new RemotePendant(
                controller,
                new PendantSetup(
                    ControllerOptions.DEFAULT_ROBOT, ProgramsFolder.at(folder), folder)));
  }

  @AfterEach
  void close() {
    ports.close();
    frames.close();
    loop.close();
  }

  @Test
  void nothingIsLeftOfManyThousandHostilePacketsAPort() throws Exception {
    sendToAll(200);
    awaitNoConnection();
    long before = usedMemory();

    sendToAll(PACKETS);
    awaitNoConnection();

    assertEquals(List.of(), List.copyOf(faults));
    assertEquals(Optional.empty(), loop.failure());
    long lines = logged.get();
    double passedS = (System.nanoTime() - beganNs) / 1e9;
    // one more a second says how many were left out
    long most = (long) ((passedS + 1) * (PeerLog.PER_SECOND + 1));
    assertTrue(lines <= most, lines + " log lines in " + passedS + " s");
    for (TcpPort port : ports.ports()) {
      assertTrue(answers(port), port.name() + " does not answer any more");
    }
    assertAProgramRuns();
    long more = usedMemory() - before;
    assertTrue(more < MORE_MEMORY, more + " bytes of memory are left over");
  }

  private void sendToAll(int packets) throws Exception {
    ExecutorService peers = Executors.newFixedThreadPool(AT_ONCE);
    try {
      List<Future<?>> running = new ArrayList<>();
      for (int i = 0; i < PEERS_A_PORT; i++) {
        for (TcpPort port : ports.ports()) {
          HostilePeer peer =
              new HostilePeer(
                  InetAddress.getLoopbackAddress(),
                  port.number(),
                  Dialect.of(port.name()),
                  SEED + running.size());
          running.add(
              peers.submit(
                  () -> {
                    peer.send(packets / PEERS_A_PORT);
                    return port;
                  }));
        }
      }
      for (Future<?> each : running) {
        each.get();
      }
    } finally {
      peers.shutdownNow();
    }
  }

  private void awaitNoConnection() throws InterruptedException {
    await(() -> ports.ports().stream().allMatch(port -> port.connections().isEmpty()));
  }

  /** Looks again after each frame. */
  private void await(BooleanSupplier condition) throws InterruptedException {
    BlockingQueue<ControllerState> seen = new LinkedBlockingQueue<>();
    Consumer<ControllerState> listener = seen::add;
    frames.add(listener);
    try {
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(GIVE_UP_S);
      while (!condition.getAsBoolean()) {
        assertTrue(System.nanoTime() < end, "still waiting after " + GIVE_UP_S + " s");
        assertFalse(seen.poll(GIVE_UP_S, TimeUnit.SECONDS) == null, "no frame any more");
      }
    } finally {
      frames.remove(listener);
    }
  }

  private static boolean answers(TcpPort port) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port.number())) {
      socket.setSoTimeout(GIVE_UP_MS);
      socket.getOutputStream().write(Dialect.of(port.name()).question());
      return socket.getInputStream().read() >= 0;
    }
  }

  private void assertAProgramRuns() throws Exception {
    // whatever the peers have switched off
    ask(new ProgramCommand.StopProgram());
    for (SafetyInput each : SafetyInput.values()) {
      ask(new SafetyCommand.SetSafetyInput(each, false));
    }
    ask(new SafetyCommand.RestartSafety());
    ask(new SafetyCommand.UnlockProtectiveStop(false));
    ask(new SafetyCommand.PowerOn());
    ask(new SafetyCommand.ReleaseBrakes());
    try (Socket socket =
        new Socket(
            InetAddress.getLoopbackAddress(),
            ports.ports().stream()
                .filter(port -> port.name().startsWith("Primary"))
                .findFirst()
                .orElseThrow()
                .number())) {
      socket
          .getOutputStream()
          .write(
              "def alive():\n  write_port_register(255, 4711)\nend\n"
                  .getBytes(StandardCharsets.ISO_8859_1));
      await(() -> PortImage.register(255, controller.state()).equals(Optional.of(4711)));
    }
  }

  private Reply ask(Command command) throws Exception {
    return controller.submit(command).get(GIVE_UP_S, TimeUnit.SECONDS);
  }

  private static long usedMemory() {
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    return runtime.totalMemory() - runtime.freeMemory();
  }
}
