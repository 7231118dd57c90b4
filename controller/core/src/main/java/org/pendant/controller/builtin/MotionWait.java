package org.pendant.controller.builtin;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.function.Call;
import org.pendant.controller.function.Outcome;
import org.pendant.controller.function.Wait;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.motion.MotionFailure;
import org.pendant.controller.motion.MotionPlan;
import org.pendant.controller.motion.MotionTicket;
import org.pendant.controller.motion.Move;
import org.pendant.controller.value.NoneValue;
import org.pendant.controller.value.ScriptError;
import org.pendant.controller.value.Value;

/** A script thread waits for the motion it has started. */
final class MotionWait implements Wait {
  private static final Optional<Value> DONE = Optional.of(NoneValue.NONE);

  private final String function;
  private final MotionTicket ticket;
  private final boolean abortable;
  private final MessageLog log;
  private boolean warned;

  private MotionWait(Call call, String function, MotionTicket ticket, boolean abortable) {
    log = call.box().log();
    this.function = function;
    this.ticket = ticket;
    this.abortable = abortable;
  }

  /** Starts a move, or leaves it out where its blend overlaps with the one before. */
  static Outcome move(Call call, String function, Move move) throws ScriptError {
    if (call.program().foresees(move)) {
      return call.answer();
    }
    try {
      call.box().drive().requirePower();
      Optional<MotionTicket> ticket = call.box().motion().start(move);
      if (ticket.isPresent()) {
        return ticket.get().finished()
            ? call.answer()
            : new MotionWait(call, function, ticket.get(), true);
      }
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
    call.box()
        .log()
        .warning(
            "Overlapping Blends: "
                + function
                + " is left out, its blend radius reaches into that of the move before; motion"
                + " version 2 would make both smaller");
    return call.answer();
  }

  /** Starts a stop from whatever the arm does; an arm at rest takes no time. */
  static Outcome stop(Call call, String function, MotionPlan plan) throws ScriptError {
    try {
      MotionTicket ticket = call.box().motion().takeOver(plan);
      return ticket.finished() ? call.answer() : new MotionWait(call, function, ticket, false);
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
  }

  /** Starts a motion that goes on from whatever the arm does and waits until it hands over. */
  static MotionWait goOn(Call call, String function, MotionPlan plan) throws ScriptError {
    try {
      call.box().drive().requirePower();
      return new MotionWait(call, function, call.box().motion().goOn(plan), false);
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
  }

  @Override
  public Optional<Value> poll(long frame) throws ScriptError {
    warnOfStretching();
    if (ticket.failure().isPresent()) {
      MotionFailure failure = ticket.failure().get();
      throw new ScriptError(failure.code(), function + ": " + failure.message());
    }
    return ticket.finished() ? DONE : Optional.empty();
  }

  private void warnOfStretching() {
    if (!warned && ticket.stretchedS() > 0) {
      warned = true;
      log.warning(
          function
              + ": the arm needs at least "
              + Value.of(ticket.stretchedS()).text()
              + " s for this way, more than t; the move takes longer");
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
  public boolean wantsOutlook() {
    return ticket.wantsOutlook();
  }

  @Override
  public void outlook(List<Move> next) {
    ticket.outlook(next);
  }

  @Override
  public void cancel() {
    ticket.cancel();
  }
}
