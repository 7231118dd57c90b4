package org.pendant.controller.device;

import java.util.Optional;
import org.pendant.controller.wire.CellSignal;
import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;

/**
 * Sensor line: the wire from a sensor to an input. It sets the input when the sensor changes, so
 * that people can force it in between.
 */
final class SensorLine {
  private final Optional<SignalLine> input;
  private boolean known;
  private boolean last;

  SensorLine(SignalLines lines, Optional<CellSignal> input) {
    this.input = input.map(lines::line);
  }

  void tell(boolean level) {
    if (input.isPresent() && (!known || level != last)) {
      input.get().set(level);
    }
    known = true;
    last = level;
  }
}
