package org.pendant.gui.command;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.pendant.controller.Command;
import org.pendant.controller.Controller;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.WallClock;
import org.pendant.protocols.BoxPorts;
import org.pendant.protocols.ScriptDoors;
import org.pendant.protocols.dashboard.DashboardServer;
import org.pendant.protocols.net.FrameFan;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.TcpPort;
import org.pendant.protocols.panel.Panel;
import org.pendant.protocols.panel.StartWatch;
import org.pendant.protocols.primary.PrimaryServer;
import org.pendant.protocols.realtime.RealtimeServer;
import org.pendant.protocols.rtde.RtdeServer;
import org.pendant.protocols.serve.MissingPort;
import org.pendant.protocols.serve.Outside;
import org.pendant.protocols.serve.PortNumbers;
import org.pendant.protocols.serve.PrivilegedPort;
import org.pendant.protocols.toolserial.ToolSerialLine;

/** One controller in real time with all its ports, from its start to its end. */
final class Service {
  /** How often the main thread looks whether it should end, ms. */
  private static final long LOOK_MS = 50;

  /** An arm that is not at rest by then never will be. */
  private static final long REST_NS = TimeUnit.SECONDS.toNanos(3);

  /** The ports that most clients need. */
  private static final Set<Integer> NEEDED =
      Set.of(
          DashboardServer.STANDARD_PORT,
          PrimaryServer.PRIMARY,
          PrimaryServer.SECONDARY,
          RealtimeServer.REALTIME,
          RtdeServer.STANDARD_PORT);

  private final ServeOptions options;
  private final Interruption interruption;
  private final Console console;

  Service(ServeOptions options, Interruption interruption, Console console) {
    this.options = options;
    this.interruption = interruption;
    this.console = console;
  }

  /** Serves until somebody ends it. */
  ExitCode run() {
    // closed last: what a program has sent before its end still goes out
    try (ToolSerialLine tool = ToolSerialOption.line(options.toolDevice());
        ScriptDoors doors = new ScriptDoors(options.hosts())) {
      return run(
          new Controller(options.controller().withOutside(doors.doors().withToolSerial(tool))),
          tool);
    }
  }

  private ExitCode run(Controller controller, ToolSerialLine tool) {
    PeerLog log = ServerLog.of(controller);
    FrameLoop loop = FrameLoop.start(controller, new WallClock());
    try (loop;
        FrameFan frames = new FrameFan(controller.feed(), log)) {
      Outside outside = new Outside(controller, frames, log, options.remote());
      return serve(outside, loop, tool);
    }
  }

  private ExitCode serve(Outside outside, FrameLoop loop, ToolSerialLine tool) {
    Panel panel = new Panel(outside.controller(), options.panel());
    PortNumbers numbers = numbers();
    try (BoxPorts ports = BoxPorts.open(outside, numbers, panel, tool)) {
      if (!complete(ports.missing())) {
        return ExitCode.UNAVAILABLE;
      }
      panel.loadAtStart();
      announce(ports.ports());
      try (LogPrinter printer = new LogPrinter(outside.controller(), console)) {
        outside.frames().add(printer::look);
        outside.frames().add(new StartWatch(outside.controller(), panel)::look);
        awaitEnd(outside.controller(), loop);
        comeToRest(outside.controller(), loop);
      }
    }
    return loop.failure().map(this::failed).orElse(ExitCode.DONE);
  }

  /** Says which ports cannot be had; answers whether it is worth while to serve without them. */
  private boolean complete(List<MissingPort> missing) {
    Optional<MissingPort> needed = missing.stream().filter(this::needed).findFirst();
    if (needed.isPresent()) {
      int others = missing.size() - 1;
      console.complain(
          "pendant serve: "
              + needed.get().why()
              + (others > 0 ? " (and " + others + " other ports)" : ""));
      return false;
    }
    missing.forEach(each -> console.complain("pendant serve: warning: " + each.why()));
    return true;
  }

  private boolean needed(MissingPort port) {
    return NEEDED.contains(port.standardPort())
        || (options.modbusChosen() && port.standardPort() == PortOptions.MODBUS);
  }

  private PortNumbers numbers() {
    PortNumbers numbers = options.numbers();
    if (!numbers.host().isLoopbackAddress()) {
      console.complain(
          "pendant serve: warning: whoever reaches "
              + numbers.host().getHostAddress()
              + " can move this robot; nobody is asked for a password");
    }
    if (options.modbusChosen() || !PrivilegedPort.forbidden(numbers, PortOptions.MODBUS)) {
      return numbers;
    }
    int instead = 1000 + PortOptions.MODBUS + numbers.offset();
    console.complain(
        "pendant serve: note: this process may not use port "
            + (PortOptions.MODBUS + numbers.offset())
            + ": Modbus listens at "
            + instead
            + "; --modbus-port chooses another one");
    return numbers.with(PortOptions.MODBUS, instead);
  }

  private void announce(List<TcpPort> ports) {
    for (TcpPort each : ports) {
      String host = options.numbers().host().getHostAddress();
      console.print(
          each.name() + " " + (host.contains(":") ? "[" + host + "]" : host) + ":" + each.number());
    }
    console.print("ready");
    console.flush();
  }

  private void awaitEnd(Controller controller, FrameLoop loop) {
    while (!interruption.awaitRequest(LOOK_MS)
        && !controller.state().safety().shutDown()
        && loop.failure().isEmpty()) {
      // nothing to do: everything happens in other threads
    }
  }

  /** Ends the program and lets the arm stop on its path. */
  private static void comeToRest(Controller controller, FrameLoop loop) {
    long begunNs = System.nanoTime();
    try {
      controller.submit(new Command.StopProgram()).get(REST_NS, TimeUnit.NANOSECONDS);
      while (controller.state().arm().moving()
          && loop.failure().isEmpty()
          && System.nanoTime() - begunNs < REST_NS) {
        TimeUnit.MILLISECONDS.sleep(2);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException | TimeoutException e) {
      // the loop has failed: that is what will be told
      return;
    }
  }

  private ExitCode failed(Throwable fault) {
    StringWriter details = new StringWriter();
    fault.printStackTrace(new PrintWriter(details, true));
    console.complain("pendant serve: internal error: " + fault);
    console.complainInLines(details.toString().stripTrailing());
    return ExitCode.INTERNAL_ERROR;
  }
}
