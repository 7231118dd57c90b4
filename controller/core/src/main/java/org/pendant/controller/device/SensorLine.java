package org.pendant.controller.device;

import java.util.Optional;
import org.pendant.controller.io.DigitalIo;
import org.pendant.controller.io.Signal;

/**
 * Sensor line: the wire from a sensor to an input. It sets the input when the sensor changes, so
 * that people can force it in between.
 */
final class SensorLine {
  private final DigitalIo io;
  private final Optional<Signal> input;
  private boolean known;
  private boolean last;

  SensorLine(DigitalIo io, Optional<Signal> input) {
    this.io = io;
    this.input = input;
  }

  void tell(boolean level) {
    if (input.isPresent() && (!known || level != last)) {
      io.set(input.get().bank(), input.get().index(), level);
    }
    known = true;
    last = level;
  }
}
