package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.Vector3;

/** Sink device: takes parts out of the cell. */
final class SinkDevice implements CellDevice {
  private final DeviceSetup.Sink setup;
  private final ContactWorld world;
  private final Vector3 min;
  private final Vector3 max;
  private boolean takes;

  SinkDevice(DeviceSetup.Sink setup, ContactWorld world) {
    this.setup = setup;
    this.world = world;
    min = setup.area().min().vector();
    max = setup.area().max().vector();
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("sink");
  }

  @Override
  public boolean on() {
    return takes;
  }

  @Override
  public String described() {
    return text("sinkOfParts");
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    takes = world.takeAway(min, max) > 0;
  }
}
