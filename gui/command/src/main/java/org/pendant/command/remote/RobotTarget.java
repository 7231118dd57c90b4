package org.pendant.command.remote;

import static org.pendant.command.remote.TargetTexts.text;

import java.io.Closeable;
import java.io.IOException;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.NoRouteToHostException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.pendant.controller.command.Command;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.protocols.dashboard.DashboardClient;
import org.pendant.protocols.primary.PrimaryLink;
import org.pendant.protocols.primary.ProgramVariables;
import org.pendant.protocols.primary.RobotMessage;
import org.pendant.protocols.rtde.ReceivedField;
import org.pendant.protocols.rtde.RtdeClient;
import org.pendant.protocols.rtde.RtdeClient.Subscription;
import org.pendant.testing.remote.TargetEvent;
import org.pendant.testing.remote.TargetState;
import org.pendant.testing.remote.TargetState.RunState;
import org.pendant.testing.remote.TargetTrouble;
import org.pendant.testing.remote.TargetVariables;
import org.pendant.testing.remote.TargetView;
import org.pendant.testing.remote.TestTarget;

/**
 * Robot target: a real robot, a simulator or a served controller that tests run on. It takes
 * programs at its primary port and tells its messages there, its state comes by RTDE, and the
 * dashboard pauses, stops and says whether it may be controlled.
 */
public final class RobotTarget implements TestTarget, Closeable {
  /** As often as states come where the controller is able to; others send as often as they can. */
  private static final double WANTED_HZ = 500;

  /** A target that tells no state for so long is gone. */
  private static final long SILENCE_NS = TimeUnit.SECONDS.toNanos(5);

  /** A program that is told to stop has stopped by then. */
  private static final long STOP_NS = TimeUnit.SECONDS.toNanos(8);

  /** A program that was sent has started by then. */
  private static final long START_NS = TimeUnit.SECONDS.toNanos(2);

  private static final int READ_ONLY = 210;
  private static final String LOCAL = "Command is not allowed";

  private final PrimaryLink primary;
  private final DashboardClient dashboard;
  private final RtdeClient rtde;
  private final TargetCommands commands;
  private List<ReceivedField> fields = List.of();
  private Optional<TargetTrouble> silent = Optional.empty();
  private boolean running;
  private boolean started;

  private RobotTarget(
      PrimaryLink primary, DashboardClient dashboard, RtdeClient rtde, TargetCommands commands) {
    this.primary = primary;
    this.dashboard = dashboard;
    this.rtde = rtde;
    this.commands = commands;
  }

  /**
   * Connects to all ports.
   *
   * @throws TargetTrouble if one of them cannot be reached, or speaks something else
   */
  public static RobotTarget connect(TargetAddress address) throws TargetTrouble {
    if (address.rtde().isUnresolved()) {
      throw new TargetTrouble(text("noSuchComputer"));
    }
    return connect(address.rtde(), address.primary(), address.dashboard());
  }

  static RobotTarget connect(
      InetSocketAddress ofRtde, InetSocketAddress ofPrimary, InetSocketAddress ofDashboard)
      throws TargetTrouble {
    List<Closeable> opened = new ArrayList<>();
    String port = "RTDE";
    InetSocketAddress at = ofRtde;
    try {
      RtdeClient rtde = RtdeClient.connect(at);
      opened.add(rtde);
      port = "primary";
      at = ofPrimary;
      PrimaryLink primary = PrimaryLink.connect(at);
      opened.add(primary);
      port = "dashboard";
      at = ofDashboard;
      DashboardClient dashboard = DashboardClient.connect(at);
      opened.add(dashboard);
      return new RobotTarget(primary, dashboard, rtde, new TargetCommands(dashboard, ofRtde));
    } catch (IOException e) {
      closeAll(opened);
      throw new TargetTrouble(text("portTrouble", at.getPort(), port, reason(e)));
    }
  }

  private static void closeAll(List<Closeable> opened) {
    for (Closeable each : opened) {
      try {
        each.close();
      } catch (IOException _) {
        // it is given up anyway
      }
    }
  }

  static String reason(IOException e) {
    return switch (e) {
      case ConnectException _ -> text("nothingListens");
      case NoRouteToHostException _ -> text("noWay");
      default -> String.valueOf(e.getMessage());
    };
  }

  @Override
  public void watch(Set<String> quantities) throws TargetTrouble {
    List<String> names = new ArrayList<>(quantities);
    try {
      while (true) {
        switch (rtde.subscribe(WANTED_HZ, names)) {
          case Subscription.Granted granted -> {
            fields = granted.fields();
            rtde.start();
            return;
          }
          case Subscription.Unknown unknown -> {
            if (!names.removeAll(unknown.names()) || !names.contains(TargetState.RUN_STATE)) {
              throw new TargetTrouble(text("doesNotTell", String.join(", ", unknown.names())));
            }
          }
        }
      }
    } catch (IOException e) {
      throw new TargetTrouble(text("rtde", reason(e)));
    }
  }

  @Override
  public void begin() throws TargetTrouble {
    // a box without remote control answers false as well, and lets everybody control it
    boolean remote = ask("is in remote control").equals("true");
    if ((!remote || fresh().runState() != RunState.STOPPED) && ask("stop").startsWith(LOCAL)) {
      throw local();
    }
    TargetState state = awaitStopped();
    int mode = (int) state.number(TargetState.ROBOT_MODE, 0);
    if (mode != RobotMode.RUNNING.code()) {
      throw new TargetTrouble(text("wrongMode", nameOfMode(mode)));
    }
    if (state.safety() > SafetyMode.REDUCED.code()) {
      throw new TargetTrouble(text("safetyStopped", TargetView.nameOfSafety(state.safety())));
    }
    running = false;
    var _ = primary.take();
    commands.begin(state);
  }

  private static String nameOfMode(int code) {
    for (RobotMode each : RobotMode.values()) {
      if (each.code() == code) {
        return each.name();
      }
    }
    return Integer.toString(code);
  }

  private static TargetTrouble local() {
    return new TargetTrouble(text("localControl"));
  }

  private TargetState awaitStopped() throws TargetTrouble {
    long endNs = System.nanoTime() + STOP_NS;
    TargetState state = fresh();
    while (state.runState() != RunState.STOPPED) {
      if (System.nanoTime() > endNs) {
        throw new TargetTrouble(text("doesNotStop"));
      }
      state = next();
    }
    return state;
  }

  /** A state of now: those that have waited are passed over. */
  private TargetState fresh() throws TargetTrouble {
    double startS = next().timeS();
    long beganNs = System.nanoTime();
    TargetState state = next();
    while (state.timeS() - startS < 0.1
        && System.nanoTime() - beganNs < TimeUnit.SECONDS.toNanos(1)) {
      state = next();
    }
    return state;
  }

  private String ask(String line) throws TargetTrouble {
    try {
      return dashboard.ask(line);
    } catch (IOException e) {
      throw new TargetTrouble(text("dashboard", reason(e)));
    }
  }

  @Override
  public void start(String script) throws TargetTrouble {
    running = true;
    started = false;
    try {
      primary.send(script);
    } catch (IOException e) {
      throw new TargetTrouble(text("primaryPort", reason(e)));
    }
  }

  @Override
  public Optional<String> carryOut(Command command) throws TargetTrouble {
    return commands.carryOut(command);
  }

  @Override
  public TargetState next() throws TargetTrouble {
    if (silent.isPresent()) {
      throw silent.get();
    }
    long endNs = System.nanoTime() + SILENCE_NS;
    while (System.nanoTime() < endNs) {
      Optional<String> lost = primary.lost();
      if (lost.isPresent()) {
        throw new TargetTrouble(text("primaryPortLost", lost.get()));
      }
      try {
        Optional<ByteBuffer> data = rtde.next();
        if (data.isPresent()) {
          return state(data.get());
        }
      } catch (IOException e) {
        throw new TargetTrouble(text("rtdeLost", reason(e)));
      }
    }
    silent =
        Optional.of(new TargetTrouble(text("noState", TimeUnit.NANOSECONDS.toSeconds(SILENCE_NS))));
    throw silent.get();
  }

  private TargetState state(ByteBuffer data) {
    Map<String, double[]> values = new HashMap<>();
    for (ReceivedField each : fields) {
      double[] numbers = new double[each.count()];
      each.read(data, numbers, 0);
      values.put(each.name(), numbers);
    }
    TargetState state = new TargetState(values);
    commands.see(state);
    return state;
  }

  @Override
  public List<TargetEvent> events() throws TargetTrouble {
    List<TargetEvent> events = new ArrayList<>();
    for (RobotMessage each : primary.take()) {
      if (each instanceof RobotMessage.ErrorCode error && error.code() == READ_ONLY && running) {
        throw local();
      }
      TargetMessages.event(each).ifPresent(events::add);
      follow(each);
    }
    return events;
  }

  @Override
  public TargetVariables variables() {
    ProgramVariables told = primary.variables();
    return new TargetVariables(told.begun(), told.whole(), told.values());
  }

  /** Whether what was sent has started, and still runs. */
  private void follow(RobotMessage message) {
    switch (message) {
      case RobotMessage.Key key when key.title().equals(TargetMessages.STARTED) -> started = true;
      case RobotMessage.Key key when key.title().equals(TargetMessages.STOPPED) ->
          running &= !started;
      case RobotMessage.RuntimeFault _ -> running &= started;
      default -> {}
    }
  }

  @Override
  public void end() throws TargetTrouble {
    commands.end();
    if (!running) {
      return;
    }
    try {
      awaitStart();
    } finally {
      // also where it tells nothing any more: it may still listen
      stop();
    }
  }

  /** What was sent but has not started would start later. */
  private void awaitStart() throws TargetTrouble {
    long endNs = System.nanoTime() + START_NS;
    while (running && !started && System.nanoTime() < endNs) {
      var _ = next();
      var _ = events();
    }
  }

  private void stop() throws TargetTrouble {
    if (running) {
      running = false;
      var _ = ask("stop");
      var _ = awaitStopped();
    }
  }

  @Override
  public void close() {
    closeAll(List.of(commands, dashboard, primary, rtde));
  }
}
