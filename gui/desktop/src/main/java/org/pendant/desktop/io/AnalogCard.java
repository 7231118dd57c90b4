package org.pendant.desktop.io;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.layout.TitledCard;

/** Analog card: the analog inputs of box and tool, or the outputs. */
final class AnalogCard {
  private final TitledCard card;
  private final List<AnalogRow> rows = new ArrayList<>();

  AnalogCard(
      String word, String title, List<AnalogBank> banks, Forcing forcing, SignalLabels labels) {
    card = new TitledCard(word, title, "[][grow,fill][][]");
    for (AnalogBank bank : banks) {
      for (int i = 0; i < AnalogBank.SIZE; i++) {
        rows.add(new AnalogRow(card, bank, i, forcing, labels));
      }
    }
  }

  JComponent component() {
    return card;
  }

  void refresh(ControllerState state) {
    rows.forEach(each -> each.refresh(state));
  }
}
