package org.pendant.controller.rule;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.rule.RuleSetup.Action;
import org.pendant.controller.rule.RuleSetup.Trigger;
import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;
import org.pendant.models.time.FrameTime;

/** A rule at work. */
final class Rule {
  /** Changes that wait for their time; of more at once the later ones are lost. */
  private static final int MAX_WAITING = 64;

  private final RuleSetup setup;
  private final Rules.DeviceActions devices;

  /** What the condition is about; nothing where there is none. */
  private final List<SignalLine> watched;

  /** What it sets, where it sets something. */
  private final Optional<SignalLine> target;

  private final long afterFrames;
  private final long forFrames;
  private final long[] due = new long[MAX_WAITING];
  private final boolean[] forth = new boolean[MAX_WAITING];
  private int waiting;
  private boolean held;
  private boolean begun;
  private long next;

  Rule(RuleSetup setup, SignalLines signals, Rules.DeviceActions devices) {
    this.setup = setup;
    this.devices = devices;
    watched =
        switch (setup.trigger()) {
          case Trigger.When when -> when.condition().watched(signals);
          case Trigger.While during -> during.condition().watched(signals);
          case Trigger.Every _ -> List.of();
        };
    target =
        setup.action() instanceof Action.Set set
            ? Optional.of(signals.line(set.signal()))
            : Optional.empty();
    afterFrames = frames(setup.afterS());
    forFrames = frames(setup.forS());
  }

  private static long frames(double timeS) {
    return timeS > 0 ? FrameTime.framesFor(timeS) : 0;
  }

  void step(long frame) {
    switch (setup.trigger()) {
      case Trigger.When when -> {
        boolean holds = when.condition().holds(watched);
        if (begun && holds && !held) {
          begin(frame);
        }
        held = holds;
      }
      case Trigger.While during -> {
        boolean holds = during.condition().holds(watched);
        if (!begun || holds != held) {
          // what has not happened yet is not to happen any more: it was too short
          waiting = 0;
          plan(frame + (holds ? afterFrames : 0), holds);
        }
        held = holds;
      }
      case Trigger.Every every -> {
        if (frame >= next) {
          next = frame + FrameTime.framesFor(every.periodS());
          begin(frame);
        }
      }
    }
    begun = true;
    carryOut(frame);
  }

  private void begin(long frame) {
    plan(frame + afterFrames, true);
    if (forFrames > 0) {
      plan(frame + afterFrames + forFrames, false);
    }
  }

  private void plan(long at, boolean wanted) {
    if (waiting < MAX_WAITING) {
      due[waiting] = at;
      forth[waiting] = wanted;
      waiting++;
    }
  }

  private void carryOut(long frame) {
    int kept = 0;
    for (int i = 0; i < waiting; i++) {
      if (due[i] <= frame) {
        act(forth[i]);
      } else {
        due[kept] = due[i];
        forth[kept] = forth[i];
        kept++;
      }
    }
    waiting = kept;
  }

  private void act(boolean wanted) {
    switch (setup.action()) {
      case Action.Set set -> target.orElseThrow().set(wanted ? set.value() : set.opposite());
      case Action.PutPart put -> devices.putPart(put.gripper(), wanted ? put.widthM() : 0);
      case Action.Press press -> devices.press(press.device(), wanted);
    }
  }
}
