package org.pendant.testing.run;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.command.Command;
import org.pendant.models.time.FrameTime;
import org.pendant.script.value.Value;
import org.pendant.testing.remote.TargetEvent;
import org.pendant.testing.remote.TargetState;
import org.pendant.testing.remote.TargetTrouble;
import org.pendant.testing.remote.TargetVariables;
import org.pendant.testing.remote.TestTarget;

/** A target that tells what it was told to tell, a state every 2 ms of its own time. */
final class ScriptedTarget implements TestTarget {
  private static final double STOPPED = 1;
  private static final double PLAYING = 2;
  private static final Pattern MARK = Pattern.compile("pendant-[0-9a-f]+");

  private record Step(
      int frames, Optional<TargetEvent> event, Map<String, double[]> change, Runnable deed) {}

  private final Map<String, double[]> values = new HashMap<>();
  private final Deque<Step> steps = new ArrayDeque<>();
  private final List<TargetEvent> events = new ArrayList<>();
  private Optional<String> lossAfterSteps = Optional.empty();
  private Optional<String> notReady = Optional.empty();
  private Optional<String> unstoppable = Optional.empty();
  private String sent = "";
  private TargetVariables variables = TargetVariables.NONE;
  private boolean playing;
  private long frame;
  private int wait;

  /** What it was asked, in order. */
  final List<String> asked = new ArrayList<>();

  ScriptedTarget() {
    values.put(TargetState.RUN_STATE, new double[] {STOPPED});
    values.put(TargetState.SAFETY_STATUS, new double[] {1});
  }

  /** It tells this from the beginning. */
  ScriptedTarget telling(String quantity, double... numbers) {
    values.put(quantity, numbers);
    return this;
  }

  /** As soon as a program was sent, and what was to come before has come, this happens. */
  ScriptedTarget then(TargetEvent event) {
    steps.add(new Step(0, Optional.of(event), Map.of(), () -> {}));
    return this;
  }

  /** It tells variables after some frames. */
  ScriptedTarget telling(int frames, Map<String, Value> told) {
    return after(
        frames,
        () -> variables = new TargetVariables(variables.begun() + 1, variables.whole() + 1, told));
  }

  /** Somebody does something after some frames. */
  ScriptedTarget after(int frames, Runnable deed) {
    steps.add(new Step(frames, Optional.empty(), Map.of(), deed));
    return this;
  }

  /** A quantity changes after some frames. */
  ScriptedTarget after(int frames, String quantity, double... numbers) {
    steps.add(new Step(frames, Optional.empty(), Map.of(quantity, numbers), () -> {}));
    return this;
  }

  /** A test that was sent as a whole tells something of itself. */
  void tell(String what) {
    Matcher mark = MARK.matcher(sent);
    if (!mark.find()) {
      throw new AssertionError(sent);
    }
    happen(new TargetEvent.Said(mark.group() + " " + what));
  }

  /** The last line of what was sent that contains this, 1-based. */
  private int lineWith(String part) {
    List<String> lines = sent.lines().toList();
    for (int i = lines.size(); i > 0; i--) {
      if (lines.get(i - 1).contains(part)) {
        return i;
      }
    }
    throw new AssertionError(part + " is not in " + sent);
  }

  /** What was sent fails in the last line that contains this, and ends. */
  void fail(String part, String why) {
    happen(new TargetEvent.Failed(lineWith(part), 1, why));
    happen(new TargetEvent.Ended());
  }

  /** After all that it is gone. */
  ScriptedTarget isLost(String why) {
    lossAfterSteps = Optional.of(why);
    return this;
  }

  /** What it runs cannot be stopped. */
  ScriptedTarget cannotBeStopped(String why) {
    unstoppable = Optional.of(why);
    return this;
  }

  /** It cannot be used. */
  ScriptedTarget isNotReady(String why) {
    notReady = Optional.of(why);
    return this;
  }

  @Override
  public void watch(Set<String> quantities) {
    asked.add("watch " + quantities.size());
  }

  @Override
  public void begin() throws TargetTrouble {
    if (notReady.isPresent()) {
      throw new TargetTrouble(notReady.get());
    }
    asked.add("begin");
  }

  @Override
  public void start(String script) {
    asked.add(script);
    sent = script;
    playing = true;
  }

  @Override
  public Optional<String> carryOut(Command command) {
    asked.add(command.toString());
    return Optional.empty();
  }

  @Override
  public TargetState next() throws TargetTrouble {
    frame++;
    while (playing && !steps.isEmpty() && wait >= steps.peek().frames()) {
      Step step = steps.poll();
      wait = 0;
      step.event().ifPresent(this::happen);
      values.putAll(step.change());
      step.deed().run();
    }
    if (playing) {
      wait++;
      if (steps.isEmpty() && lossAfterSteps.isPresent()) {
        throw new TargetTrouble(lossAfterSteps.get());
      }
    }
    values.put(TargetState.TIME, new double[] {100 + FrameTime.FRAME_S * frame});
    return new TargetState(values);
  }

  private void happen(TargetEvent event) {
    events.add(event);
    switch (event) {
      case TargetEvent.Started _ -> values.put(TargetState.RUN_STATE, new double[] {PLAYING});
      case TargetEvent.Ended _ -> values.put(TargetState.RUN_STATE, new double[] {STOPPED});
      default -> {}
    }
  }

  @Override
  public List<TargetEvent> events() {
    List<TargetEvent> taken = List.copyOf(events);
    events.clear();
    return taken;
  }

  @Override
  public TargetVariables variables() {
    return variables;
  }

  @Override
  public void end() throws TargetTrouble {
    asked.add("end");
    if (unstoppable.isPresent()) {
      throw new TargetTrouble(unstoppable.get());
    }
  }
}
