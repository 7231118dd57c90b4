package org.pendant.gui.io;

import javax.swing.JLabel;
import org.pendant.controller.io.Signal;

/** The light of a signal that cannot be set here. */
@SuppressWarnings("serial") // never written to a stream
final class Lamp extends JLabel {
  private static final LevelIcon LOW = new LevelIcon(LevelIcon.Form.LAMP, false);
  private static final LevelIcon HIGH = new LevelIcon(LevelIcon.Form.LAMP, true);

  private final Signal signal;
  private boolean high;

  Lamp(Signal signal) {
    super(LOW);
    this.signal = signal;
    setName(SignalName.id(signal));
    describe();
  }

  boolean high() {
    return high;
  }

  void showLevel(boolean level) {
    if (level != high) {
      high = level;
      setIcon(level ? HIGH : LOW);
      describe();
    }
  }

  private void describe() {
    String text = signal + " is " + (high ? "high" : "low");
    setToolTipText(text + ", in scripts " + SignalName.inScript(signal));
    getAccessibleContext().setAccessibleName(text);
  }
}
