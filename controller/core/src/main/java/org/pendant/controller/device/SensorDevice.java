package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.Optional;
import org.pendant.controller.wire.SignalLines;

/** Sensor device: tells by an input whether it sees the tool centre point or a body. */
final class SensorDevice implements CellDevice {
  private final DeviceSetup.Sensor setup;
  private final ZoneWatch zone;
  private final SensorLine line;
  private boolean sees;

  SensorDevice(DeviceSetup.Sensor setup, ZoneWatch zone, SignalLines lines) {
    this.setup = setup;
    this.zone = zone;
    line = new SensorLine(lines, Optional.of(setup.signal()));
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("sensor");
  }

  @Override
  public boolean on() {
    return sees;
  }

  @Override
  public String described() {
    return text("sensorAt", setup.signal());
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    sees = zone.sees();
    line.tell(sees != setup.inverted());
  }
}
