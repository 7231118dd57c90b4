package org.pendant.controller.jog;

import static org.pendant.controller.jog.JogTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Refusal.Code;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.PlanningException;
import org.pendant.motion.StopJ;

/**
 * Jogging: moves the arm as long as a client repeats that it should. When the repetitions stay away
 * for {@value #DEAD_MAN_S} s of robot time, the arm comes to rest on its path: a screen that hangs
 * moves nothing.
 */
public final class Jogging {
  /** Speed of the fastest joint at full speed, rad/s. */
  public static final double JOINT_SPEED_RAD_PER_S = 0.6;

  /** Speed of the TCP at full speed, m/s; what is customary while people are near. */
  public static final double TOOL_SPEED_M_PER_S = 0.25;

  /** Longest time between two repetitions, s of robot time. */
  public static final double DEAD_MAN_S = 0.25;

  private static final long DEAD_MAN_FRAMES = FrameTime.framesFor(DEAD_MAN_S);

  private final ControlBox box;
  private final JogPlanner planner;
  private final StopPrediction stopPrediction;
  private Optional<Hold> hold = Optional.empty();

  /** What the arm does by hand, until it rests or its joints stop: its failures are of jogging. */
  private Optional<JogMove> underway = Optional.empty();

  /** What the operator holds, and how it goes. */
  private static final class Hold {
    final JogMove move;
    final MotionTicket ticket;
    long lastFrame;
    boolean over;
    Optional<Refusal> reason = Optional.empty();

    Hold(JogMove move, MotionTicket ticket, long lastFrame) {
      this.move = move;
      this.ticket = ticket;
      this.lastFrame = lastFrame;
    }
  }

  /** Jogging for an arm; nothing moves at first. */
  public Jogging(ControlBox box) {
    this.box = box;
    planner = new JogPlanner(box);
    stopPrediction = new StopPrediction(box);
  }

  /**
   * Begins a move, or keeps it going. A move that has ended by itself stays so until it is released
   * or another one is asked for.
   *
   * @param speedFraction share of the highest speed for moves by hand, above 0 and at most 1; the
   *     one given first counts
   * @return why the arm does not move, or not any further; empty when it moves or is at its goal
   */
  public Optional<Refusal> hold(JogMove move, double speedFraction) {
    if (!(speedFraction > 0 && speedFraction <= 1)) {
      return Optional.of(new Refusal(Code.INVALID, text("speed", speedFraction)));
    }
    if (hold.isPresent() && hold.get().move.equals(move)) {
      hold.get().lastFrame = box.clock().frame() + DEAD_MAN_FRAMES;
      return hold.get().reason;
    }
    release();
    Optional<Refusal> refusal = refusal();
    return refusal.isPresent() ? refusal : begin(move, speedFraction);
  }

  private Optional<Refusal> begin(JogMove move, double speedFraction) {
    try {
      box.motion().resume();
      box.motion().clearFault();
      MotionTicket ticket = box.motion().start(planner.plan(move, speedFraction));
      hold = Optional.of(new Hold(move, ticket, box.clock().frame() + DEAD_MAN_FRAMES));
      underway = Optional.of(move);
      return Optional.empty();
    } catch (PlanningException e) {
      return Optional.of(new Refusal(Code.ARM_RANGE, e.getMessage()));
    }
  }

  /** Why the arm cannot be moved by hand now. In recovery it can: that is how it gets back. */
  private Optional<Refusal> refusal() {
    return box.safety().safetyMode() == SafetyMode.RECOVERY
        ? Optional.empty()
        : box.safety().programRefusal();
  }

  /** Lets the arm come to rest on its path. */
  public void release() {
    hold.ifPresent(present -> present.ticket.cancel());
    hold = Optional.empty();
  }

  /** As {@link #release}; the next motion is none of this class, even if it begins before rest. */
  public void giveUp() {
    release();
    underway = Optional.empty();
  }

  /** Looks at how the move goes; after the step of the motion in each frame. */
  public void step() {
    if (hold.isPresent() && box.clock().frame() > hold.get().lastFrame) {
      release();
    }
    if (underway.isPresent()) {
      endAfterFault();
      if (box.safety().stop().isEmpty()) {
        lookAhead(straight(underway.get()));
      }
    }
    if (hold.isPresent() && !hold.get().over) {
      watch(hold.get());
    }
    if (!box.motion().moving()) {
      underway = Optional.empty();
    }
  }

  /** The path led nowhere: the arm stops by itself, which is nothing that a program did. */
  private void endAfterFault() {
    if (box.motion().fault().isPresent()) {
      String reason = box.motion().fault().get().message();
      box.motion().clearFault();
      if (hold.isPresent() && !hold.get().over) {
        end(hold.get(), reason);
      } else {
        box.log().warning(text("joggingRefused", reason));
      }
    }
  }

  private void watch(Hold present) {
    Optional<Refusal> stopped = refusal();
    if (stopped.isPresent()) {
      // the log has the stop itself
      present.over = true;
      present.reason = stopped;
      present.ticket.cancel();
    } else if (present.ticket.finished()) {
      finish(present);
    }
  }

  /** Before a limit the joints stop, also when the arm only comes to rest: its path leads there. */
  private void lookAhead(boolean straight) {
    Optional<String> obstacle = stopPrediction.obstacle(planner, straight);
    if (obstacle.isPresent()) {
      if (hold.isPresent() && !hold.get().over) {
        end(hold.get(), obstacle.get());
      }
      stopJoints();
    }
  }

  /** What the outlook reckons with; on a straight path joints may continue to turn faster. */
  private void stopJoints() {
    underway = Optional.empty();
    try {
      box.motion()
          .takeOver((from, speed) -> new StopJ(from, speed, StopPrediction.STOP_RAD_PER_S2))
          .cancel();
    } catch (PlanningException e) {
      // another motion waits for the arm already, which comes to rest on its path
      box.log().warning(text("joggingRefused", e.getMessage()));
    }
  }

  private static boolean straight(JogMove move) {
    return switch (move) {
      case JogMove.MoveTool _, JogMove.StraightTo _ -> true;
      case JogMove.TurnJoint _, JogMove.ToJoints _, JogMove.ToPose _ -> false;
    };
  }

  private void finish(Hold present) {
    if (present.move instanceof JogMove.TurnJoint turn) {
      end(present, text("jointAtEnd", turn.joint()));
    }
    present.over = true;
  }

  private void end(Hold present, String reason) {
    present.over = true;
    present.reason = Optional.of(new Refusal(Code.ARM_RANGE, reason));
    present.ticket.cancel();
    box.log().warning(text("joggingRefused", reason));
  }
}
