package org.pendant.controller.device;

import java.util.Optional;
import org.pendant.cell.BodyProbe;
import org.pendant.controller.wire.SignalLines;

/** Sensor device: tells by an input whether it sees the tool centre point or a body. */
final class SensorDevice implements CellDevice {
  private final DeviceSetup.Sensor setup;
  private final ToolPlaces tools;
  private final Optional<BodyProbe> bodies;
  private final SensorLine line;
  private boolean sees;

  SensorDevice(
      DeviceSetup.Sensor setup, ToolPlaces tools, Optional<BodyProbe> bodies, SignalLines lines) {
    this.bodies = bodies;
    this.setup = setup;
    this.tools = tools;
    line = new SensorLine(lines, Optional.of(setup.signal()));
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return "sensor";
  }

  @Override
  public boolean on() {
    return sees;
  }

  @Override
  public String described() {
    return "sensor at " + setup.signal();
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    sees = tools.anyIn(setup.zone()) || (bodies.isPresent() && bodies.get().sees());
    line.tell(sees != setup.inverted());
  }
}
