package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Supplier;
import org.pendant.command.service.RobotAccess;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.Robot;
import org.pendant.editors.dap.DebugAdapterConnection;
import org.pendant.editors.dap.run.AttachableRobot;
import org.pendant.editors.dap.run.DebugTarget;
import org.pendant.editors.dap.run.TargetRefusal;
import org.pendant.editors.wire.LoopbackListener;
import org.pendant.editors.wire.ProtocolLog;
import org.pendant.language.source.Source;
import org.pendant.text.Language;

/** Attach port: where editors attach to a robot that others drive, to debug the programs on it. */
final class AttachPort implements AutoCloseable, RobotAccess {
  static final Option OPTION =
      Option.of("--dap", new OptionArgument.Whole("P", 1, 65535))
          .documented(
              "P",
              "let an editor [attach](editors.md#attaching) to the robot at port P of 127.0.0.1,"
                  + " 1 to 65535, and debug the programs that run on it; with one robot only");

  private final String prefix;
  private final LoopbackListener listener;
  private final Console console;
  private final ProtocolLog log;
  private volatile Optional<AttachableRobot> robot = Optional.empty();

  /**
   * Opens the port; there is no robot yet.
   *
   * @param command that it is opened by
   * @throws UsageException if it is taken
   */
  AttachPort(String command, int port, Console console) throws UsageException {
    this.console = console;
    prefix = "pendant " + command + ": ";
    try {
      listener = new LoopbackListener(port);
    } catch (IOException e) {
      throw new UsageException(text("portOfCannotBeOpened", OPTION.name(), port, e.getMessage()));
    }
    log = new ProtocolLog(line -> console.complain(prefix + line));
    Thread.ofVirtual().name("attach port").start(() -> listener.serve(this::serve));
  }

  /** Opens the port that was asked for, if one was. */
  static Optional<AttachPort> of(String command, OptionalInt port, Console console)
      throws UsageException {
    return port.isPresent()
        ? Optional.of(new AttachPort(command, port.getAsInt(), console))
        : Optional.empty();
  }

  @Override
  public void show(Robot shown, Supplier<Optional<Source>> program) {
    robot = Optional.of(new AttachableRobot(shown, program));
  }

  @Override
  public void hide() {
    robot = Optional.empty();
    listener.disconnect();
  }

  private void serve(InputStream in, OutputStream out) throws InterruptedException {
    DebugAdapterConnection.serve(
        AttachPort::nothing,
        robot,
        in,
        out,
        fault -> console.complain(text("internalErrorAt", prefix, fault)),
        complaint -> console.complain(prefix + OPTION.name() + ": " + complaint));
  }

  private static DebugTarget nothing(String program, List<String> options, Language language)
      throws TargetRefusal {
    throw new TargetRefusal(CommandLanguage.spoken(language, () -> text("nothingLaunched")));
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
