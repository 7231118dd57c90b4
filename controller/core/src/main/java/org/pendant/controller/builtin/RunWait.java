package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Locale;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.PlanningException;
import org.pendant.motion.toolpath.BackgroundTask;
import org.pendant.motion.toolpath.RunPlan;
import org.pendant.motion.toolpath.Toolpaths;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Wait of a script thread for a run of queued motions: until the arm rests, until the run is
 * planned, and until it is over. Meanwhile the arm must stay near its path.
 */
final class RunWait implements Wait {
  private static final String FUNCTION = "mc_run_motion";
  private static final Optional<Value> DONE = Optional.of(NoneValue.NONE);

  private final ControlBox box;
  private final int last;
  private Optional<BackgroundTask<RunPlan>> planning = Optional.empty();
  private Optional<RunPlan> plan = Optional.empty();
  private Optional<MotionTicket> ticket = Optional.empty();

  /**
   * A wait.
   *
   * @param last the number of the last motion
   */
  RunWait(ControlBox box, int last) throws PlanningException {
    this.box = box;
    this.last = last;
    planAtRest();
  }

  private void planAtRest() throws PlanningException {
    MotionControl motion = box.motion();
    if (!motion.moving()) {
      box.clock().determinism().loseInRealTime(text("waitedForPlan"));
      planning =
          Optional.of(
              box.planning()
                  .toolpaths()
                  .plan(last, motion.pathPositionRad(), box.flange().tool().inFlange()));
    }
  }

  @Override
  public Optional<Value> poll(long frame) throws ScriptError {
    try {
      Optional<Value> answer = step();
      if (answer.isPresent()) {
        box.planning().toolpaths().ran(last, plan.orElseThrow());
      }
      return answer;
    } catch (PlanningException e) {
      cancel();
      throw Planning.failure(FUNCTION, e.failure());
    } catch (ScriptError e) {
      cancel();
      throw new ScriptError(e.code(), FUNCTION + ": " + e.getMessage());
    }
  }

  private Optional<Value> step() throws PlanningException, ScriptError {
    if (ticket.isPresent()) {
      return follow(ticket.get());
    }
    if (planning.isEmpty()) {
      box.drive().requirePower();
      planAtRest();
      return Optional.empty();
    }
    if (!planning.get().over()) {
      return Optional.empty();
    }
    RunPlan made = planning.get().result();
    plan = Optional.of(made);
    if (made.motion().isEmpty()) {
      return DONE;
    }
    ticket = Optional.of(box.motion().start((from, speed) -> made.begin(from)));
    return Optional.empty();
  }

  private Optional<Value> follow(MotionTicket running) throws PlanningException, ScriptError {
    if (running.failure().isPresent()) {
      throw new PlanningException(running.failure().get());
    }
    if (running.finished()) {
      return DONE;
    }
    double apartM =
        box.planning()
            .toolpaths()
            .divergenceM(
                box.kinematics().forward(),
                box.drive().drivenPositionRad(),
                box.drive().actualPositionRad());
    if (apartM > Toolpaths.DIVERGENCE_M) {
      throw new ScriptError(
          "path-divergence",
          text(
              "besidePath",
              String.format(Locale.ROOT, "%.1f", 1000 * apartM),
              String.format(Locale.ROOT, "%.0f", 1000 * Toolpaths.DIVERGENCE_M)));
    }
    return Optional.empty();
  }

  @Override
  public void cancel() {
    ticket.ifPresent(MotionTicket::cancel);
    if (planning.isPresent()) {
      box.planning().toolpaths().ended();
    }
  }
}
