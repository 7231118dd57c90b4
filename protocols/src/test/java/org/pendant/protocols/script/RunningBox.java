package org.pendant.protocols.script;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.WallClock;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.ServerContext;

/** A controller whose frames go by, for servers that are tested over real sockets. */
public final class RunningBox implements AutoCloseable {
  /** When a test has waited in vain. */
  public static final int GIVE_UP_MS = 20_000;

  private final Controller controller;
  private final FrameLoop loop;
  private final StateBroadcaster frames;
  private final BlockingQueue<String> logged = new LinkedBlockingQueue<>();
  private final ServerContext serverContext;

  /** A box that may be controlled from outside or not. */
  public RunningBox(ControllerOptions options, RemoteControl remote) {
    controller = new Controller(options);
    PeerLog log = new PeerLog((level, text) -> logged.add(text));
    frames = new StateBroadcaster(controller.feed(), log);
    serverContext = new ServerContext(controller, frames, log, remote);
    loop = FrameLoop.start(controller, new WallClock());
  }

  /** What servers get. */
  public ServerContext serverContext() {
    return serverContext;
  }

  public Controller controller() {
    return controller;
  }

  /** The next line that a server writes to the log. */
  public String nextLogged() throws InterruptedException {
    String line = logged.poll(GIVE_UP_MS, TimeUnit.MILLISECONDS);
    if (line == null) {
      throw new AssertionError("nothing was logged");
    }
    return line;
  }

  @Override
  public void close() {
    loop.close();
    frames.close();
  }
}
