package org.pendant.controller.device;

import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.cell.BodyProbe;
import org.pendant.controller.wire.SignalLines;
import org.pendant.models.pose.Pose;

/** Sensor device: tells by an input whether it sees the tool centre point or a body. */
final class SensorDevice implements CellDevice {
  private final DeviceSetup.Sensor setup;
  private final Supplier<Pose> tcpInBase;
  private final Optional<BodyProbe> bodies;
  private final SensorLine line;
  private boolean sees;

  SensorDevice(
      DeviceSetup.Sensor setup,
      Supplier<Pose> tcpInBase,
      Optional<BodyProbe> bodies,
      SignalLines lines) {
    this.bodies = bodies;
    this.setup = setup;
    this.tcpInBase = tcpInBase;
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
    Pose tcp = tcpInBase.get();
    sees =
        setup.zone().holds(tcp.x(), tcp.y(), tcp.z())
            || (bodies.isPresent() && bodies.get().sees());
    line.tell(sees != setup.inverted());
  }
}
