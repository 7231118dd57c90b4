package org.pendant.controller.device;

import org.pendant.controller.io.DigitalIo;

/** Lamp device: shows a signal. */
final class LampDevice implements CellDevice {
  private final DeviceSetup.Lamp setup;
  private final DigitalIo io;
  private boolean lit;

  LampDevice(DeviceSetup.Lamp setup, DigitalIo io) {
    this.setup = setup;
    this.io = io;
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return "lamp";
  }

  @Override
  public boolean on() {
    return lit;
  }

  @Override
  public String described() {
    return "lamp at " + setup.signal();
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    lit = io.level(setup.signal().bank(), setup.signal().index());
  }
}
