package org.pendant.controller.rule;

import java.util.List;
import org.pendant.controller.io.DigitalIo;

/** Rules of a cell at work; the frame loop owns them. */
public final class Rules {
  /** Who has parts put between the fingers of grippers, and switches pressed. */
  public interface Hand {
    /** As {@link RuleSetup.Action.PutPart}. */
    void putPart(String gripper, double widthM);

    /** As {@link RuleSetup.Action.Press}. */
    void press(String device, boolean pressed);
  }

  private final List<Rule> rules;
  private final DigitalIo io;
  private final Hand hand;
  private long frame;

  /** Rules over signals. */
  public Rules(List<RuleSetup> setups, DigitalIo io, Hand hand) {
    rules = setups.stream().map(Rule::new).toList();
    this.io = io;
    this.hand = hand;
  }

  /** Looks at the signals and does what is due, once a frame. */
  public void step() {
    for (int i = 0; i < rules.size(); i++) {
      rules.get(i).step(io, hand, frame);
    }
    frame++;
  }
}
