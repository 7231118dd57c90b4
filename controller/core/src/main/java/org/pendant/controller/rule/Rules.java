package org.pendant.controller.rule;

import java.util.List;
import org.pendant.controller.io.DigitalIo;

/** Rules of a cell at work; the frame loop owns them. */
public final class Rules {
  /** Who has parts put between the fingers of grippers. */
  @FunctionalInterface
  public interface Parts {
    /** As {@link RuleSetup.Action.PutPart}. */
    void put(String gripper, double widthM);
  }

  private final List<Rule> rules;
  private final DigitalIo io;
  private final Parts parts;
  private long frame;

  /** Rules over signals. */
  public Rules(List<RuleSetup> setups, DigitalIo io, Parts parts) {
    rules = setups.stream().map(Rule::new).toList();
    this.io = io;
    this.parts = parts;
  }

  /** Looks at the signals and does what is due, once a frame. */
  public void step() {
    for (int i = 0; i < rules.size(); i++) {
      rules.get(i).step(io, parts, frame);
    }
    frame++;
  }
}
