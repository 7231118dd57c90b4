package org.pendant.controller.wire;

import java.util.HashMap;
import java.util.Map;

/** Signal lines of a cell: its signals at work, by their names. The frame loop owns them. */
public final class SignalLines {
  private final Map<String, SignalOwner> owners = new HashMap<>();

  /** The signals of one owner, which need no name in front. */
  public SignalLines(SignalOwner own) {
    owners.put("", own);
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
    SignalOwner owner = owners.get(signal.owner());
    if (owner == null) {
      throw new IllegalArgumentException(
          "signal is " + signal + ", but there is no " + signal.owner() + " in the cell");
    }
    return owner.line(signal.group(), signal.index());
  }
}
