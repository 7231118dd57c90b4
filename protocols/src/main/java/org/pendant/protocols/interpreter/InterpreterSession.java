package org.pendant.protocols.interpreter;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import org.pendant.controller.InterpreterCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.LineCutter;
import org.pendant.protocols.net.ProtocolException;
import org.pendant.protocols.net.Session;
import org.pendant.script.vm.InterpretedLine;
import org.pendant.script.vm.Interpreter;
import org.pendant.script.vm.InterpreterStatus;

/**
 * Interpreter session: one client of interpreter mode. Lines are answered when the controller has
 * dealt with them; control lines are not delayed by statements that wait.
 */
final class InterpreterSession implements Session {
  private static final int MAX_LINE = 1 << 16;

  /** Most control lines of one client in a frame. */
  private static final int MAX_UNANSWERED = 16;

  private static final String NOT_REMOTE = "the robot is not in remote control";

  private final Connection connection;
  private final Robot robot;
  private final boolean mayControl;
  private final LineCutter lines = new LineCutter(MAX_LINE);
  private final LineQueue statements;
  private final Semaphore unanswered = new Semaphore(MAX_UNANSWERED);

  /**
   * A client that has just connected.
   *
   * @param mayControl whether it may do more than ask, as long as it stays connected
   */
  InterpreterSession(Connection connection, Robot robot, boolean mayControl) {
    this.connection = connection;
    this.robot = robot;
    this.mayControl = mayControl;
    statements = new LineQueue(robot, (line, reply) -> send(answer(reply, line.text())));
  }

  @Override
  public void received(ByteBuffer bytes) throws ProtocolException {
    for (String line : lines.take(bytes)) {
      if (line.isBlank()) {
        continue;
      }
      Optional<ControlLine> control = ControlLine.of(line);
      if (control.isPresent()) {
        obey(control.get());
      } else {
        interpret(line);
      }
    }
  }

  private void obey(ControlLine line) {
    String word = line.word();
    switch (line) {
      case ABORT -> act(new ProgramCommand.AbortMove(), word);
      case SKIPBUFFER -> act(new InterpreterCommand.SkipInterpreted(), word);
      case STATELASTEXECUTED, STATELASTINTERPRETED, STATELASTCLEARED, STATEUNEXECUTED ->
          submit(
              new InterpreterCommand.AskInterpreter(),
              reply -> "state: " + value(line, reply) + ": " + word);
    }
  }

  /** What comes of it is of no interest to clients (manual 13.5, 13.6); they wait for a line. */
  private void act(Command command, String word) {
    if (mayControl) {
      submit(command, reply -> "ack: 0: " + word);
    } else {
      send(discard(NOT_REMOTE, word));
    }
  }

  private static int value(ControlLine line, Reply reply) {
    if (!(reply instanceof Reply.InterpreterState(InterpreterStatus status))) {
      return 0;
    }
    return switch (line) {
      case STATELASTEXECUTED -> status.lastExecuted();
      case STATELASTINTERPRETED -> status.lastInterpreted();
      case STATELASTCLEARED -> status.lastCleared();
      case STATEUNEXECUTED -> status.unexecuted();
      case ABORT, SKIPBUFFER -> 0;
    };
  }

  private void interpret(String line) {
    if (!mayControl) {
      send(discard(NOT_REMOTE, line));
      return;
    }
    try {
      statements.add(InterpretedLine.read(line));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static String answer(Reply reply, String line) {
    return switch (reply) {
      case Reply.Interpreted(Interpreter.Response.Acknowledged acknowledged) ->
          "ack: " + acknowledged.id() + ": " + line;
      case Reply.Interpreted(Interpreter.Response.Discarded discarded) ->
          discard(discarded.reason(), line);
      case Reply.Refused _, Reply.Failed _, Reply.Busy _ ->
          discard(reply.complaint().orElseThrow(), line);
      case Reply.Done _, Reply.InterpreterState _, Reply.Told _, Reply.Returned _ ->
          throw new IllegalStateException("not an answer to a line: " + reply);
    };
  }

  private static String discard(String reason, String line) {
    return "discard: " + reason + ": " + line;
  }

  @FunctionalInterface
  private interface Wording {
    String of(Reply reply);
  }

  /** Has the controller carry out a command; the answer goes out when it has. */
  private void submit(Command command, Wording wording) {
    try {
      unanswered.acquire();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return;
    }
    // in the frame loop: this puts a short line into the connection's outbox and returns
    var _ =
        robot
            .submit(command)
            .thenAccept(
                reply -> {
                  unanswered.release();
                  send(wording.of(reply));
                });
  }

  private void send(String line) {
    connection.send((line + "\n").getBytes(StandardCharsets.ISO_8859_1));
  }
}
