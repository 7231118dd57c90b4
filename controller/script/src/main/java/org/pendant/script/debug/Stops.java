package org.pendant.script.debug;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import org.pendant.script.value.Operators;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.vm.DebugHook;
import org.pendant.script.vm.ProgramProbe;
import org.pendant.script.vm.ScriptFailure;
import org.pendant.script.vm.ThreadSnapshot;

/** Stop decision of a debugger: where a program stops, and where it did. */
final class Stops implements DebugHook {
  private final ProgramProbe probe;
  private final Breakpoints breakpoints;
  private final Consumer<String> log;
  private Optional<StepRequest> step = Optional.empty();
  private boolean trapsForStep;
  private boolean onErrors;
  private boolean following;
  private long count;
  private DebugState state = DebugState.FREE;

  /** Decides for the program of {@code probe}; {@code log} takes what breakpoints write. */
  Stops(ProgramProbe probe, Breakpoints breakpoints, Consumer<String> log) {
    this.probe = probe;
    this.log = log;
    this.breakpoints = breakpoints;
  }

  DebugState state() {
    if (following && !state.held()) {
      List<ThreadSnapshot> threads = probe.followedThreads();
      if (!threads.equals(state.threads())) {
        state = new DebugState(Optional.empty(), threads);
      }
    }
    return state;
  }

  void followCalls(boolean wanted) {
    following = wanted;
    if (!wanted && !state.held()) {
      state = DebugState.FREE;
    }
  }

  boolean onErrors() {
    return onErrors;
  }

  void onErrors(boolean wanted) {
    onErrors = wanted;
  }

  /** The program continues, to stop again after {@code step}. */
  void go(Optional<StepRequest> step) {
    this.step = step;
    setTraps();
    state = DebugState.FREE;
  }

  /** A thread of the paused program has gone, perhaps the one that stopped it. */
  void threadKilled() {
    DebugState.Stop stop = state.stop().orElseThrow();
    List<ThreadSnapshot> threads = probe.threads();
    ThreadSnapshot main = threads.getFirst();
    boolean gone = threads.stream().noneMatch(each -> each.id() == stop.thread());
    DebugState.Stop now =
        gone ? new DebugState.Stop(stop.number(), stop.reason(), main.id(), main.line()) : stop;
    state = new DebugState(Optional.of(now), threads);
  }

  /** Sets the traps that breakpoints and the present step need. */
  void setTraps() {
    Set<Integer> starts = breakpoints.starts();
    trapsForStep = step.isPresent();
    if (step.isEmpty()) {
      probe.trap(starts);
      return;
    }
    switch (step.get()) {
      case StepRequest.Into into -> probe.trapEverything();
      case StepRequest.Over over -> probe.trapCalls(starts, over.thread());
      case StepRequest.Out out -> probe.trapCalls(starts, out.thread());
      case StepRequest.To to -> probe.trap(both(starts, Set.of(to.start())));
      case StepRequest.ToAny any when any.past().isPresent() ->
          probe.trapCalls(both(starts, any.starts()), any.thread());
      case StepRequest.ToAny any -> probe.trap(both(starts, any.starts()));
    }
  }

  private static Set<Integer> both(Set<Integer> some, Set<Integer> others) {
    Set<Integer> both = new HashSet<>(some);
    both.addAll(others);
    return both;
  }

  /** Notes a stop, and where everything stands. */
  void stop(PauseReason reason, int thread) {
    step = Optional.empty();
    int line =
        reason instanceof PauseReason.Failed failed
            ? failed.failure().line()
            : probe.snapshot(thread).line();
    state =
        new DebugState(
            Optional.of(new DebugState.Stop(++count, reason, thread, line)), probe.threads());
  }

  private boolean completes(StepRequest wanted, int thread, OptionalInt start) {
    boolean steps = thread == wanted.thread();
    return switch (wanted) {
      case StepRequest.Into into -> steps;
      case StepRequest.Over over -> steps && probe.depthSince(over.calls(), thread) > 0;
      case StepRequest.Out out -> {
        int depth = steps ? probe.depthSince(out.calls(), thread) : 0;
        yield depth > 0 && depth < out.calls().depth();
      }
      case StepRequest.To to -> steps && start.equals(OptionalInt.of(to.start()));
      case StepRequest.ToAny any ->
          (start.isPresent() && any.starts().contains(start.getAsInt()))
              || (steps
                  && any.past().filter(calls -> probe.depthSince(calls, thread) > 0).isPresent());
    };
  }

  private Optional<PauseReason> hit(Breakpoints.Entry entry, int thread) {
    Breakpoint breakpoint = entry.breakpoint();
    if (!breakpoint.condition().isEmpty()) {
      try {
        Value value = probe.evaluate(thread, probe.depth(thread), breakpoint.condition());
        if (!Operators.truth(value)) {
          return Optional.empty();
        }
      } catch (ScriptError e) {
        return Optional.of(new PauseReason.ConditionFailed(breakpoint.line(), e.getMessage()));
      }
    }
    long hits = entry.countHit();
    if (!breakpoint.hits().counts(hits)) {
      return Optional.empty();
    }
    if (breakpoint.logs()) {
      log.accept(text(entry.message(), thread));
      return Optional.empty();
    }
    return Optional.of(new PauseReason.AtBreakpoint(breakpoint.line(), hits));
  }

  /** The message with values in place of its expressions; one that fails says why. */
  private String text(LogMessage message, int thread) {
    StringBuilder text = new StringBuilder();
    for (LogMessage.Part part : message.parts()) {
      if (!part.expression()) {
        text.append(part.text());
        continue;
      }
      try {
        text.append(ShortText.of(probe.evaluate(thread, probe.depth(thread), part.text())));
      } catch (ScriptError e) {
        text.append('{').append(part.text()).append(": ").append(e.getMessage()).append('}');
      }
    }
    return text.toString();
  }

  // --- what the machine asks and tells

  @Override
  public boolean stopsAt(int thread) {
    OptionalInt start = probe.statementStart(thread);
    Optional<PauseReason> reason = Optional.empty();
    if (start.isPresent()) {
      for (Breakpoints.Entry entry : breakpoints.at(start.getAsInt())) {
        Optional<PauseReason> why = hit(entry, thread);
        reason = reason.isPresent() ? reason : why;
      }
    }
    if (reason.isEmpty() && step.isPresent() && completes(step.get(), thread, start)) {
      reason = Optional.of(new PauseReason.Stepped());
    }
    reason.ifPresent(why -> stop(why, thread));
    if (reason.isEmpty() && step.isEmpty() && trapsForStep) {
      // the thread that made the step has ended
      setTraps();
    }
    return reason.isPresent();
  }

  @Override
  public boolean stopsAtFailure(int thread, ScriptFailure failure) {
    if (onErrors) {
      stop(new PauseReason.Failed(failure), thread);
    }
    return onErrors;
  }

  @Override
  public void programStarted() {
    step = Optional.empty();
    state = DebugState.FREE;
    probe.program().ifPresent(breakpoints::bind);
    setTraps();
  }

  @Override
  public void programEnded() {
    step = Optional.empty();
    state = DebugState.FREE;
  }

  @Override
  public void threadEnded(int thread) {
    step = step.flatMap(each -> each.without(thread));
  }
}
