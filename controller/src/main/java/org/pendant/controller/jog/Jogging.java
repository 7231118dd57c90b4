package org.pendant.controller.jog;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.motion.FrameTime;
import org.pendant.controller.motion.MotionTicket;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.value.ScriptError;

/**
 * Moves the arm as long as somebody repeats that it should. When the repetitions stay away for
 * {@value #DEAD_MAN_S} s of robot time, the arm comes to rest on its path: a screen that hangs
 * moves nothing.
 */
public final class Jogging {
  /** Longest time between two repetitions, s of robot time. */
  public static final double DEAD_MAN_S = 0.25;

  private static final long DEAD_MAN_FRAMES = FrameTime.framesFor(DEAD_MAN_S);

  private final ControlBox box;
  private final JogPlanner planner;
  private final Outlook outlook;
  private Optional<Hold> hold = Optional.empty();

  /** The motion is of this class, so its failures are, too; true until the arm rests. */
  private boolean moving;

  /** What somebody holds, and how it goes. */
  private static final class Hold {
    final JogMove move;
    final MotionTicket ticket;
    long lastFrame;
    boolean over;
    Optional<String> reason = Optional.empty();

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
    outlook = new Outlook(box);
  }

  /**
   * Begins a move, or keeps it going. A move that has ended by itself stays so until it is released
   * or another one is asked for.
   *
   * @param speedFraction share of the highest speed for moves by hand, above 0 and at most 1; the
   *     one given first counts
   * @return why the arm does not move, or not any further; empty when it moves or is at its goal
   */
  public Optional<String> hold(JogMove move, double speedFraction) {
    if (!(speedFraction > 0 && speedFraction <= 1)) {
      return Optional.of("speed is " + speedFraction + ", must be above 0 and at most 1");
    }
    if (hold.isPresent() && hold.get().move.equals(move)) {
      hold.get().lastFrame = box.frame() + DEAD_MAN_FRAMES;
      return hold.get().reason;
    }
    release();
    Optional<String> refusal = refusal();
    return refusal.isPresent() ? refusal : begin(move, speedFraction);
  }

  private Optional<String> begin(JogMove move, double speedFraction) {
    try {
      box.motion().resume();
      box.motion().clearFault();
      MotionTicket ticket = box.motion().start(planner.plan(move, speedFraction));
      hold = Optional.of(new Hold(move, ticket, box.frame() + DEAD_MAN_FRAMES));
      moving = true;
      return Optional.empty();
    } catch (ScriptError e) {
      return Optional.of(e.getMessage());
    }
  }

  /** Why the arm cannot be moved by hand now. In recovery it can: that is how it gets back. */
  private Optional<String> refusal() {
    return box.safety().safetyMode() == SafetyMode.RECOVERY
        ? Optional.empty()
        : box.safety().programRefusal();
  }

  /** Lets the arm come to rest on its path. */
  public void release() {
    hold.ifPresent(present -> present.ticket.cancel());
    hold = Optional.empty();
  }

  /** Looks at how the move goes; after the step of the motion in each frame. */
  public void step() {
    if (hold.isPresent() && box.frame() > hold.get().lastFrame) {
      release();
    }
    if (moving) {
      endAfterFault();
    }
    if (hold.isPresent() && !hold.get().over) {
      watch(hold.get());
    }
    moving = moving && box.motion().moving();
  }

  /** The path led nowhere: the arm stops by itself, which is nothing that a program did. */
  private void endAfterFault() {
    if (box.motion().fault().isPresent()) {
      String reason = box.motion().fault().get().message();
      box.motion().clearFault();
      if (hold.isPresent() && !hold.get().over) {
        end(hold.get(), reason);
      } else {
        box.log().warning("jogging: " + reason);
      }
    }
  }

  private void watch(Hold present) {
    Optional<String> stopped = refusal();
    if (stopped.isPresent()) {
      // the log has the stop itself
      present.over = true;
      present.reason = stopped;
      present.ticket.cancel();
    } else if (present.ticket.finished()) {
      finish(present);
    } else {
      outlook.obstacle(planner).ifPresent(reason -> end(present, reason));
    }
  }

  private void finish(Hold present) {
    if (present.move instanceof JogMove.TurnJoint turn) {
      end(present, "joint " + turn.joint() + " is at the end of its range");
    }
    present.over = true;
  }

  private void end(Hold present, String reason) {
    present.over = true;
    present.reason = Optional.of(reason);
    present.ticket.cancel();
    box.log().warning("jogging: " + reason);
  }
}
