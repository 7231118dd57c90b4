package org.pendant.gui.io;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingConstants;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.gui.layout.Card;

/** The flags, eight lamps a row with their numbers below. */
final class FlagCard {
  private static final int PER_ROW = 8;

  private final Card card = new Card("Flags", "[grow,fill,center]".repeat(PER_ROW));
  private final List<Lamp> lamps = new ArrayList<>();
  private final IoPresenter presenter;

  FlagCard(IoPresenter presenter) {
    this.presenter = presenter;
    for (int i = 0; i < SignalBank.FLAG.size(); i++) {
      Lamp lamp = new Lamp(new Signal(SignalBank.FLAG, i));
      lamp.setText(Integer.toString(i));
      lamp.setHorizontalTextPosition(SwingConstants.CENTER);
      lamp.setVerticalTextPosition(SwingConstants.BOTTOM);
      lamp.setIconTextGap(0);
      lamps.add(lamp);
      card.add(lamp);
    }
    JLabel note = new JLabel("Set by programs with set_flag");
    note.setEnabled(false);
    card.add(note, "span, gaptop 4");
  }

  JComponent component() {
    return card;
  }

  void refresh() {
    for (int i = 0; i < lamps.size(); i++) {
      lamps.get(i).showLevel(presenter.level(new Signal(SignalBank.FLAG, i)));
    }
  }
}
