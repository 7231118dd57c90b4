package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.message.MessageLog;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.Move;
import org.pendant.motion.PlanningException;
import org.pendant.script.function.Call;
import org.pendant.script.function.Foreseen;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Wait of a script thread for the motion that it has started. */
final class MotionWait implements Wait {
  private static final Optional<Value> DONE = Optional.of(NoneValue.NONE);

  private final String function;
  private final MotionTicket ticket;
  private final boolean abortable;
  private final MessageLog log;
  private boolean warned;

  private MotionWait(
      Call<ControlBox> call, String function, MotionTicket ticket, boolean abortable) {
    log = call.host().log();
    this.function = function;
    this.ticket = ticket;
    this.abortable = abortable;
  }

  /** Starts a move, or leaves it out where its blend overlaps with the one before. */
  static Outcome move(Call<ControlBox> call, String function, Move move) throws ScriptError {
    if (call.program().foresees(new ForeseenMove(move))) {
      return call.answer();
    }
    Optional<MotionTicket> ticket =
        Planning.named(
            call,
            () -> {
              call.host().drive().requirePower();
              return call.host().motion().start(move);
            });
    if (ticket.isPresent()) {
      return ticket.get().finished()
          ? call.answer()
          : new MotionWait(call, function, ticket.get(), true);
    }
    call.host().log().warning(text("moveLeftOut", function));
    return call.answer();
  }

  /** Starts a stop from whatever the arm does; an arm at rest takes no time. */
  static Outcome stop(Call<ControlBox> call, String function, MotionPlan plan) throws ScriptError {
    MotionTicket ticket = Planning.named(call, () -> call.host().motion().takeOver(plan));
    return ticket.finished() ? call.answer() : new MotionWait(call, function, ticket, false);
  }

  /** Starts a motion that continues from whatever the arm does and waits until it hands over. */
  static MotionWait continueWith(Call<ControlBox> call, String function, MotionPlan plan)
      throws ScriptError {
    try {
      call.host().drive().requirePower();
      return new MotionWait(call, function, call.host().motion().continueWith(plan), false);
    } catch (PlanningException e) {
      throw Planning.failure(call, e);
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
  }

  @Override
  public Optional<Value> poll(long frame) throws ScriptError {
    warnOfStretching();
    if (ticket.failure().isPresent()) {
      throw Planning.failure(function, ticket.failure().get());
    }
    return ticket.finished() ? DONE : Optional.empty();
  }

  private void warnOfStretching() {
    if (!warned && ticket.stretchedS() > 0) {
      warned = true;
      log.warning(text("moveTakesLonger", function, Value.of(ticket.stretchedS()).text()));
    }
  }

  @Override
  public boolean abort() {
    if (abortable) {
      ticket.endEarly();
    }
    return abortable;
  }

  @Override
  public boolean wantsLookAhead() {
    return ticket.wantsOutlook();
  }

  @Override
  public void lookAhead(List<Foreseen> next) {
    List<Move> moves = new ArrayList<>(next.size());
    for (Foreseen each : next) {
      if (each instanceof ForeseenMove foreseen) {
        moves.add(foreseen.move());
      }
    }
    ticket.outlook(moves);
  }

  @Override
  public void cancel() {
    ticket.cancel();
  }
}
