package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.WallClock;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.protocols.BoxPorts;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.protocols.dashboard.DashboardServer;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.primary.PrimaryServer;
import org.pendant.protocols.realtime.RealtimeServer;
import org.pendant.protocols.rtde.RtdeServer;
import org.pendant.protocols.server.MissingPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.PrivilegedPort;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.teachpendant.LoadTrouble;
import org.pendant.protocols.teachpendant.RemotePendant;
import org.pendant.protocols.teachpendant.StartWatch;
import org.pendant.protocols.toolserial.ToolSerialLine;
import org.pendant.protocols.trace.TraceFile;
import org.pendant.protocols.trace.WireTrace;

/** Served robot: one controller in real time with all its ports. */
final class ServedRobot implements AutoCloseable {
  /** The ports that most clients need. */
  private static final Set<Integer> NEEDED =
      Set.of(
          DashboardServer.STANDARD_PORT,
          PrimaryServer.PRIMARY,
          PrimaryServer.SECONDARY,
          RealtimeServer.REALTIME,
          RtdeServer.STANDARD_PORT);

  private final ServeOptions options;
  private final Console console;
  private final Doors doors;
  private final Robot robot;
  private final Supplier<Optional<Source>> program;
  private final FrameLoop loop;
  private final StateBroadcaster frames;
  private final RemotePendant remotePendant;
  private final BoxPorts ports;
  private final String prefix;
  private Optional<LogPrinter> printer = Optional.empty();
  private Optional<WireTrace> trace = Optional.empty();
  private Optional<AttachPort> attachPort = Optional.empty();

  /**
   * What its programs reach of the world outside.
   *
   * @param tool the serial line of its tool
   */
  record Doors(ToolSerialLine tool, ScriptConnectors connectors) {
    static Doors of(ServeOptions options) {
      return new Doors(
          ToolSerialOption.line(options.toolDevice()), new ScriptConnectors(options.hosts()));
    }

    /** How a controller with these doors is switched on. */
    ControllerOptions in(ControllerOptions options) {
      return options.withOutside(connectors.connectors().withToolSerial(tool));
    }
  }

  /** Switches a controller on that is alone, opens its ports and begins with the frames. */
  static ServedRobot alone(ServeOptions options, Console console, String prefix) {
    Doors doors = Doors.of(options);
    Controller controller = new Controller(doors.in(options.controller()));
    FrameLoop loop = FrameLoop.start(controller, new WallClock());
    return new ServedRobot(options, doors, controller, loop, console, prefix);
  }

  /**
   * Opens the ports.
   *
   * @param doors those that the controller was made with
   * @param loop drives the controller, and perhaps others
   * @param prefix stands before each line that it prints
   */
  ServedRobot(
      ServeOptions options,
      Doors doors,
      Controller controller,
      FrameLoop loop,
      Console console,
      String prefix) {
    this.options = options;
    this.doors = doors;
    this.loop = loop;
    this.console = console;
    this.prefix = prefix;
    robot = controller;
    program = controller::programSource;
    PeerLog log = ServerLog.of(robot);
    frames = new StateBroadcaster(robot.feed(), log);
    ServerContext serverContext = new ServerContext(robot, frames, log, options.remote());
    remotePendant = new RemotePendant(robot, options.panel());
    ports = BoxPorts.open(serverContext, numbers(), remotePendant, doors.tool());
  }

  /** Says which ports cannot be had; answers whether it is worth while to serve without them. */
  boolean complete() {
    List<MissingPort> missing = ports.missing();
    Optional<MissingPort> needed = missing.stream().filter(this::needed).findFirst();
    if (needed.isPresent()) {
      int others = missing.size() - 1;
      console.complain(
          "pendant serve: "
              + (others > 0
                  ? text("portAndOthers", needed.get().why(), others)
                  : CommandLanguage.shown(needed.get().why())));
      return false;
    }
    missing.forEach(each -> console.complain(text("serveWarning", each.why())));
    return true;
  }

  private boolean needed(MissingPort port) {
    return NEEDED.contains(port.standardPort())
        || (options.modbusChosen() && port.standardPort() == PortOptions.MODBUS);
  }

  private PortNumbers numbers() {
    PortNumbers numbers = options.numbers();
    if (!numbers.host().isLoopbackAddress()) {
      console.complain(text("anyComputerMoves", numbers.host().getHostAddress()));
    }
    if (options.modbusChosen() || !PrivilegedPort.forbidden(numbers, PortOptions.MODBUS)) {
      return numbers;
    }
    int instead = 1000 + PortOptions.MODBUS + numbers.offset();
    console.complain(text("modbusElsewhere", PortOptions.MODBUS + numbers.offset(), instead));
    return numbers.with(PortOptions.MODBUS, instead);
  }

  /**
   * Writes from now on what goes over its connections, if that was asked for.
   *
   * @throws UsageException if the file cannot be written
   */
  void trace() throws UsageException {
    if (options.trace().isPresent()) {
      OutputFile file = options.trace().get();
      try {
        WireTrace begun =
            TraceFile.begin(
                file.path(),
                file.stream(),
                () -> robot.state().timeS(),
                why -> console.complain(text("traceEnds", why)));
        trace = Optional.of(begun);
        ports.tap(Optional.of(begun));
        doors.connectors().tap(Optional.of(begun));
      } catch (IOException e) {
        throw new UsageException(text("cannotBeWritten", file.name(), FileTrouble.reason(e)));
      }
    }
  }

  /**
   * Lets editors attach from now on, if that was asked for.
   *
   * @throws UsageException if the port is taken
   */
  void letAttach() throws UsageException {
    attachPort = AttachPort.of("serve", options.attachPort(), console);
    attachPort.ifPresent(each -> each.show(robot, program));
  }

  private void endTrace() {
    if (trace.isPresent()) {
      trace.get().close();
      long leftOut = trace.get().leftOut();
      if (leftOut > 0) {
        console.complain(text("messagesNotTraced", leftOut));
      }
    }
  }

  /** Says where its ports are. */
  void announce() {
    String host = options.numbers().host().getHostAddress();
    for (TcpPort each : ports.ports()) {
      console.print(
          each.name() + " " + (host.contains(":") ? "[" + host + "]" : host) + ":" + each.number());
    }
  }

  /**
   * Loads a program, or else the one that its installation names, if any.
   *
   * @param wanted file of the program that the scene names for it
   */
  void load(Optional<String> wanted) {
    if (wanted.isEmpty()) {
      remotePendant.loadAtStart();
      return;
    }
    String file = Path.of(wanted.get()).toAbsolutePath().normalize().toString();
    try {
      var _ = remotePendant.load(ByteText.asBytes(file));
    } catch (LoadTrouble e) {
      console.complain(text("notLoaded", prefix, wanted.get(), ByteText.decoded(e.getMessage())));
    }
  }

  /** Prints from now on what it says. */
  void printLog() {
    LogPrinter log =
        new LogPrinter(
            robot,
            console,
            prefix,
            place -> remotePendant.receivedAt(place.source(), place.line()));
    printer = Optional.of(log);
    frames.add(log::look);
    frames.add(new StartWatch(robot, remotePendant)::look);
  }

  /** Whether nothing more comes of it. */
  boolean over() {
    return robot.state().safety().shutDown() || loop.failure().isPresent();
  }

  /** What ended it although it was not asked to end. */
  Optional<Throwable> failure() {
    return loop.failure();
  }

  /** Asks its program to end. */
  Future<?> stop() {
    return robot.submit(new ProgramCommand.StopProgram());
  }

  /**
   * Waits until the program has ended and the arm has stopped on its path.
   *
   * @param stopped what {@link #stop} answered
   * @param untilNs by {@link System#nanoTime}
   */
  void awaitRest(Future<?> stopped, long untilNs) throws InterruptedException {
    try {
      stopped.get(Math.max(0, untilNs - System.nanoTime()), TimeUnit.NANOSECONDS);
      while (robot.state().arm().moving() && !over() && System.nanoTime() < untilNs) {
        TimeUnit.MILLISECONDS.sleep(2);
      }
    } catch (ExecutionException | TimeoutException e) {
      // the loop has failed: that is what will be told
      return;
    }
  }

  @Override
  public void close() {
    // tool and doors last: what a program has sent before its end still goes out
    try (ToolSerialLine _ = doors.tool();
        ScriptConnectors _ = doors.connectors();
        loop;
        frames;
        ports) {
      attachPort.ifPresent(AttachPort::close);
      printer.ifPresent(LogPrinter::close);
    }
    endTrace();
  }
}
