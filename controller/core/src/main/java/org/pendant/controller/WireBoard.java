package org.pendant.controller;

import java.util.List;
import org.pendant.controller.layout.SignalWire;
import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;

/**
 * Wire board: leads signals of the controllers in a cell to inputs of others. A frame takes all
 * levels before it sets any, so that each wire takes one frame, whatever their order.
 */
final class WireBoard {
  private final List<SignalLine> from;
  private final List<SignalLine> to;
  private final boolean[] levels;

  /** Wires between signals. */
  WireBoard(List<SignalWire> wires, SignalLines signals) {
    from = wires.stream().map(each -> signals.line(each.from())).toList();
    to = wires.stream().map(each -> signals.line(each.to())).toList();
    levels = new boolean[wires.size()];
  }

  /** Leads on what was set in the frame before. */
  void step() {
    for (int i = 0; i < levels.length; i++) {
      levels[i] = from.get(i).high();
    }
    for (int i = 0; i < levels.length; i++) {
      if (to.get(i).high() != levels[i]) {
        to.get(i).set(levels[i]);
      }
    }
  }
}
