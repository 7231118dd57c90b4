package org.pendant.controller.rule;

import java.util.List;
import org.pendant.controller.wire.SignalLines;

/** Rules of a cell at work; the frame loop owns them. */
public final class Rules {
  /** Who has parts put between the fingers of grippers, and switches pressed. */
  public interface DeviceActions {
    /** As {@link RuleSetup.Action.PutPart}. */
    void putPart(String gripper, double widthM);

    /** As {@link RuleSetup.Action.Press}. */
    void press(String device, boolean pressed);
  }

  private final List<Rule> rules;
  private long frame;

  /** Rules over signals. */
  public Rules(List<RuleSetup> setups, SignalLines signals, DeviceActions devices) {
    rules = setups.stream().map(setup -> new Rule(setup, signals, devices)).toList();
  }

  /** Looks at the signals and does what is due, once a frame. */
  public void step() {
    for (int i = 0; i < rules.size(); i++) {
      rules.get(i).step(frame);
    }
    frame++;
  }
}
