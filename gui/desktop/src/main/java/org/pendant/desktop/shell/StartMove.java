package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.EventQueue;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Reply;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.move.JogHold;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.shell.start.StartArm;
import org.pendant.kit.background.Background;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.models.arm.Joints;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/**
 * Start move: moves the arm to where a program starts: by a small program of its own, so that
 * speed, pause and stop are those of programs, or by jogging.
 */
final class StartMove implements StartArm {
  /** About a third of what joint moves have when a program names no speed. */
  private static final double SPEED_RAD_PER_S = 0.35;

  private static final double ACCELERATION_RAD_PER_S2 = 0.7;

  private final RobotSession session;
  private final Runnable beforeStart;
  private final JogHold hold;
  private Optional<Move> move = Optional.empty();

  /** A move from its start to its end. */
  private static final class Move {
    private final Consumer<String> ended;

    /** The frame in which the controller had begun it at the latest; -1 before that. */
    private long begunFrame = -1;

    Move(Consumer<String> ended) {
      this.ended = ended;
    }
  }

  /**
   * Moves the arm of a session.
   *
   * @param beforeStart follows each move that is about to start, in the dispatch thread
   */
  StartMove(RobotSession session, Runnable beforeStart) {
    this.session = session;
    this.beforeStart = beforeStart;
    hold = new JogHold(session::submit, EventQueue::invokeLater);
  }

  static String script(Joints goalRad) {
    String joints =
        Arrays.stream(goalRad.toArray())
            .mapToObj(Double::toString)
            .collect(Collectors.joining(", "));
    return "def move_to_start():\n  movej(["
        + joints
        + "], a="
        + ACCELERATION_RAD_PER_S2
        + ", v="
        + SPEED_RAD_PER_S
        + ")\nend\n";
  }

  @Override
  public void go(Joints goalRad, Consumer<String> ended) {
    Move begun = new Move(ended);
    move = Optional.of(begun);
    Source source = Source.of("move_to_start", script(goalRad));
    Background.run(
        () -> session.load(source),
        loadResult -> {
          if (is(begun)) {
            run(begun, loadResult.program().orElseThrow());
          }
        },
        failed -> end(begun, text("theMoveCannotBegin", failed.getMessage())));
  }

  private void run(Move begun, Program program) {
    beforeStart.run();
    var _ =
        session
            .run(program)
            .thenAccept(reply -> EventQueue.invokeLater(() -> answered(begun, reply)));
  }

  private void answered(Move begun, Reply reply) {
    Optional<String> refusal = reply.complaint();
    if (refusal.isPresent()) {
      end(begun, text("refused", ByteText.decoded(refusal.get())));
    } else {
      begun.begunFrame = session.state().frame();
    }
  }

  private boolean is(Move other) {
    return move.filter(each -> each == other).isPresent();
  }

  private void end(Move begun, String why) {
    if (is(begun)) {
      move = Optional.empty();
      begun.ended.accept(why);
    }
  }

  /** Time goes by. */
  void refresh(ControllerState state) {
    hold.repeat();
    if (move.isPresent()
        && move.get().begunFrame >= 0
        && state.frame() > move.get().begunFrame
        && state.program().state() == ProgramState.STOPPED) {
      end(move.get(), state.program().ending().map(StartMove::why).orElse(""));
    }
  }

  private static String why(Ending ending) {
    return switch (ending) {
      case Ending.Finished finished -> "";
      case Ending.Halted halted -> "";
      case Ending.Stopped stopped -> text("theMoveWasStopped");
      case Ending.Failed failed -> Messages.shown(ByteText.decoded(failed.failure().message()));
    };
  }

  @Override
  public void stop() {
    boolean begun = move.filter(each -> each.begunFrame >= 0).isPresent();
    move = Optional.empty();
    if (begun) {
      var _ = session.submit(new ProgramCommand.StopProgram());
    }
  }

  @Override
  public void hold(Joints goalRad) {
    hold.press(new JogMove.ToJoints(goalRad), 1);
  }

  @Override
  public void release() {
    hold.release();
  }

  @Override
  public String heldBecause() {
    return Messages.shown(ByteText.decoded(hold.reason()));
  }
}
