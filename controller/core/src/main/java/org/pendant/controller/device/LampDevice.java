package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;

/** Lamp device: shows a signal. */
final class LampDevice implements CellDevice {
  private final DeviceSetup.Lamp setup;
  private final SignalLine line;
  private boolean lit;

  LampDevice(DeviceSetup.Lamp setup, SignalLines lines) {
    this.setup = setup;
    line = lines.line(setup.signal());
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("lamp");
  }

  @Override
  public boolean on() {
    return lit;
  }

  @Override
  public String described() {
    return text("lampAt", setup.signal());
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    lit = line.high();
  }
}
