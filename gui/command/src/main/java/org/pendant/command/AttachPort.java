package org.pendant.command;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.List;
import java.util.Optional;
import org.pendant.editors.dap.DebugAdapterConnection;
import org.pendant.editors.dap.run.AttachableRobot;
import org.pendant.editors.dap.run.DebugTarget;
import org.pendant.editors.dap.run.TargetRefusal;
import org.pendant.editors.wire.LoopbackListener;
import org.pendant.editors.wire.ProtocolLog;

/** Attach port: where editors attach to a robot that is served, to debug the programs on it. */
final class AttachPort implements AutoCloseable {
  static final Option OPTION =
      Option.of(
              "--dap",
              new OptionArgument.Whole("P", 1, 65535),
              "let editors attach to the robot at this port of 127.0.0.1 and debug its programs")
          .documented(
              "P",
              "let an editor [attach](editors.md#attaching) to the robot at port P of 127.0.0.1,"
                  + " 1 to 65535, and debug the programs that run on it; with one robot only");

  private final LoopbackListener listener;
  private final AttachableRobot robot;
  private final Console console;
  private final ProtocolLog log;

  /**
   * Opens the port.
   *
   * @throws UsageException if it is taken
   */
  AttachPort(int port, AttachableRobot robot, Console console) throws UsageException {
    this.robot = robot;
    this.console = console;
    try {
      listener = new LoopbackListener(port);
    } catch (IOException e) {
      throw new UsageException(
          OPTION.name() + ": port " + port + " cannot be opened: " + e.getMessage());
    }
    log = new ProtocolLog(line -> console.complain("pendant serve: " + line));
    Thread.ofVirtual().name("attach port").start(() -> listener.serve(this::serve));
  }

  private void serve(InputStream in, OutputStream out) throws InterruptedException {
    DebugAdapterConnection.serve(
        AttachPort::nothing,
        Optional.of(robot),
        in,
        out,
        fault -> console.complain("pendant serve: internal error: " + fault),
        complaint -> console.complain("pendant serve: " + OPTION.name() + ": " + complaint));
  }

  private static DebugTarget nothing(String program, List<String> options) throws TargetRefusal {
    throw new TargetRefusal(
        "nothing is launched at a robot that is served: attach to it, and have the program started"
            + " by one of its ports");
  }

  @Override
  public void close() {
    log.close();
    try {
      listener.close();
    } catch (IOException e) {
      // it takes no more clients, which is all that is wanted
    }
  }
}
