package org.pendant.command.rpc;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Clock;
import org.pendant.controller.Controller;
import org.pendant.controller.Drive;
import org.pendant.controller.Robot;
import org.pendant.controller.VirtualClock;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.message.Operator;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingRing;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.Program;

/**
 * Driven robot: a controller in virtual time, its recording, and the program that was loaded last.
 * Used by one thread alone.
 */
final class DrivenRobot implements AutoCloseable {
  /** Memory of the recording: some minutes of an arm that never rests. */
  private static final long RECORDING_BYTES = 64L << 20;

  /** A program that may be started. */
  record Loaded(Program program, Optional<ProgramsFolder> folder, String file) {}

  private final Robot robot;
  private final Drive drive;
  private final Clock clock = new VirtualClock();
  private final ScriptConnectors connectors;
  private final RobotSource.ProgramReader programs;
  private final Optional<RecordingRing> ring;
  private Optional<Loaded> loaded = Optional.empty();
  private String startedFile = "";

  private DrivenRobot(
      Controller controller,
      ScriptConnectors connectors,
      RobotSource.ProgramReader programs,
      boolean recorded) {
    robot = controller;
    drive = controller;
    this.connectors = connectors;
    this.programs = programs;
    ring =
        recorded
            ? Optional.of(
                new RecordingRing(controller.state(), controller::programSource, RECORDING_BYTES))
            : Optional.empty();
  }

  /**
   * Switches a robot on.
   *
   * @param wanted what it begins with
   * @param attended whether popups and questions wait for answers by commands
   * @param recorded whether its frames are kept
   */
  static DrivenRobot begin(
      RobotSource.NewRobot wanted,
      boolean attended,
      boolean recorded,
      Builtins<ControlBox> builtins) {
    ScriptConnectors connectors = new ScriptConnectors(wanted.hosts());
    try {
      var options = wanted.options().withOutside(connectors.connectors());
      Controller controller =
          new Controller(attended ? options.withOperator(Operator.present()) : options, builtins);
      DrivenRobot session = new DrivenRobot(controller, connectors, wanted.programs(), recorded);
      if (!wanted.waveforms().equals(InputWaveforms.NONE)) {
        var _ = session.submit(new IoCommand.PlayInputs(wanted.waveforms()));
      }
      return session;
    } catch (RuntimeException | Error e) {
      connectors.close();
      throw e;
    }
  }

  Robot robot() {
    return robot;
  }

  Drive drive() {
    return drive;
  }

  ControllerState state() {
    return robot.state();
  }

  RobotSource.ProgramReader programs() {
    return programs;
  }

  Optional<Loaded> loaded() {
    return loaded;
  }

  /** A program may be started from now on, or none. */
  void load(Optional<Loaded> program) {
    loaded = program;
  }

  /** The file of the program that was started last. */
  String startedFile() {
    return startedFile;
  }

  void started(String file) {
    startedFile = file;
  }

  /** What was recorded; empty where nothing is. */
  Optional<Recording> recording() {
    return ring.map(RecordingRing::recording);
  }

  /** Has the controller carry out a command while robot time stands. */
  void ask(Command command) throws RpcFailure {
    Reply reply = submit(command);
    switch (reply) {
      case Reply.Refused refused -> throw RpcFailure.of(refused.refusal());
      case Reply.Failed failed ->
          throw new RpcFailure(
              RpcFailure.PROGRAM,
              failed.failure().message(),
              StateRecord.place(failed.failure(), startedFile));
      case Reply.Busy busy -> throw new RpcFailure(RpcFailure.REFUSED, busy.text());
      case Reply.Done _,
          Reply.InterpreterState _,
          Reply.Interpreted _,
          Reply.Told _,
          Reply.Returned _ -> {}
    }
  }

  private Reply submit(Command command) {
    CompletableFuture<Reply> reply = robot.submit(command);
    drive.applyCommands();
    ring.ifPresent(kept -> kept.take(drive.state()));
    return reply.join();
  }

  /** Lets a frame pass; while a peer outside is waited for, no faster than the wall clock. */
  void advance() {
    try {
      var _ = clock.awaitDue(drive::waitsForOutside);
    } catch (InterruptedException e) {
      throw new IllegalStateException("nobody interrupts the thread that runs the frames", e);
    }
    drive.advance();
    ring.ifPresent(kept -> kept.take(drive.state()));
  }

  @Override
  public void close() {
    connectors.close();
  }
}
