package org.pendant.controller.wire;

import static org.pendant.controller.wire.SignalNameTexts.text;

import java.util.HashMap;
import java.util.Map;

/** Signal lines of a cell: its signals at work, by their names. The frame loop owns them. */
public final class SignalLines {
  private final SignalOwner own;
  private final Map<String, SignalOwner> owners;

  /** The signals of one owner, which need no name in front. */
  public SignalLines(SignalOwner own) {
    this(own, new HashMap<>());
  }

  private SignalLines(SignalOwner own, Map<String, SignalOwner> owners) {
    this.own = own;
    this.owners = owners;
  }

  /**
   * The same signals as they are called where another owner needs no name in front; what comes to
   * one comes to both.
   */
  public SignalLines of(SignalOwner another) {
    return new SignalLines(another, owners);
  }

  /** From now on there are the signals of another owner. */
  public void add(String owner, SignalOwner signals) {
    owners.put(owner, signals);
  }

  /**
   * A signal at work.
   *
   * @throws IllegalArgumentException if its owner is not there, or has no such signal
   */
  public SignalLine line(CellSignal signal) {
    SignalOwner owner = signal.owner().isEmpty() ? own : owners.get(signal.owner());
    if (owner == null) {
      throw new IllegalArgumentException(text("noOwner", signal, signal.owner()));
    }
    return owner.line(signal.group(), signal.index());
  }
}
