package org.pendant.fuzz;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.WallClock;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.message.Operator;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.BoxPorts;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.teachpendant.PendantSetup;
import org.pendant.protocols.teachpendant.RemotePendant;

/** A box with all its ports in this process, and what must hold whatever clients have done. */
final class FuzzedBox implements AutoCloseable {
  private static final int PATIENCE_S = 60;

  /** Threads that compile, and those that carry virtual ones, come and go. */
  private static final int MORE_THREADS = 16;

  private final Controller controller =
      new Controller(ControllerOptions.headless().withOperator(Operator.present()));
  private final BlockingQueue<String> faults = new LinkedBlockingQueue<>();
  private final PeerLog log =
      new PeerLog(
          (level, text) -> {
            if (text.contains("internal error")) {
              faults.add(text);
            }
          });
  private final StateBroadcaster frames = new StateBroadcaster(controller.feed(), log);
  private final FrameLoop loop = FrameLoop.start(controller, new WallClock());
  private final BoxPorts ports;
  private int threads;

  /** In real time, at free ports of the loopback interface. */
  FuzzedBox(Path folder) {
    ports =
        BoxPorts.open(
            new ServerContext(controller, frames, log, RemoteControl.disabled()),
            PortNumbers.anyFree(),
            new RemotePendant(
                controller,
                new PendantSetup(
                    ControllerOptions.DEFAULT_ROBOT, ProgramsFolder.at(folder), folder)));
  }

  List<TcpPort> ports() {
    return ports.ports();
  }

  /** Notes what there is now: there may not be much more later. */
  void remember() {
    threads = liveThreads();
  }

  /**
   * Looks whether nothing is left of clients that have gone, and all continues.
   *
   * @return what is wrong; empty if nothing is
   */
  Optional<String> complaint() throws InterruptedException {
    long frame = controller.state().frame();
    if (!await(() -> controller.state().frame() > frame)) {
      return Optional.of("no frame any more: " + loop.failure());
    }
    if (!await(() -> ports().stream().allMatch(port -> port.connections().isEmpty()))) {
      return Optional.of("connections are left: " + left());
    }
    for (TcpPort each : ports()) {
      if (!answers(each)) {
        return Optional.of(each.name() + " does not answer any more");
      }
    }
    if (liveThreads() > threads + MORE_THREADS) {
      return Optional.of(liveThreads() + " threads, there were " + threads);
    }
    return Optional.ofNullable(faults.poll())
        .or(() -> loop.failure().map(each -> "the frame loop has failed: " + each));
  }

  private String left() {
    return String.join(
        ", ",
        ports().stream()
            .flatMap(port -> port.connections().stream())
            .map(each -> each.name())
            .toList());
  }

  private static int liveThreads() {
    return ManagementFactory.getThreadMXBean().getThreadCount();
  }

  private static boolean answers(TcpPort port) {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port.number())) {
      socket.setSoTimeout((int) TimeUnit.SECONDS.toMillis(PATIENCE_S));
      // thousands of closed connections would use all numbers up
      socket.setSoLinger(true, 0);
      for (byte[] each : Vocabulary.of(port.name()).question()) {
        socket.getOutputStream().write(each);
      }
      return socket.getInputStream().read() >= 0;
    } catch (IOException e) {
      return false;
    }
  }

  /** Looks again after each frame; answers whether it came to hold. */
  private boolean await(BooleanSupplier condition) throws InterruptedException {
    BlockingQueue<ControllerState> seen = new LinkedBlockingQueue<>();
    Consumer<ControllerState> listener = seen::add;
    frames.add(listener);
    try {
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
      while (!condition.getAsBoolean()) {
        if (System.nanoTime() > end || seen.poll(PATIENCE_S, TimeUnit.SECONDS) == null) {
          return false;
        }
      }
      return true;
    } finally {
      frames.remove(listener);
    }
  }

  @Override
  public void close() {
    ports.close();
    frames.close();
    loop.close();
  }
}
