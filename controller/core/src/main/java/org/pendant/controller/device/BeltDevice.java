package org.pendant.controller.device;

import java.util.Optional;
import org.pendant.controller.io.DigitalIo;
import org.pendant.controller.io.Signal;
import org.pendant.controller.world.BeltSurface;
import org.pendant.models.time.FrameTime;

/** Belt device: carries what lies on it, and turns an encoder. */
final class BeltDevice implements CellDevice {
  private final DeviceSetup.Belt setup;
  private final Optional<BeltSurface> belt;
  private final EncoderTicks encoders;
  private final DigitalIo io;
  private double speedMPerS;
  private boolean told;

  BeltDevice(
      DeviceSetup.Belt setup, Optional<BeltSurface> belt, EncoderTicks encoders, DigitalIo io) {
    this.setup = setup;
    this.belt = belt;
    this.encoders = encoders;
    this.io = io;
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return "belt";
  }

  @Override
  public boolean on() {
    return speedMPerS != 0;
  }

  @Override
  public String described() {
    return "belt "
        + setup.object()
        + (setup.encoder() < 0 ? "" : " that turns encoder " + setup.encoder());
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    Optional<Signal> run = setup.run();
    boolean runs = run.isEmpty() || io.level(run.get().bank(), run.get().index());
    double wanted = runs ? setup.speedMPerS() : 0;
    double most = setup.accelerationMPerS2() * FrameTime.FRAME_S;
    double next = speedMPerS + Math.clamp(wanted - speedMPerS, -most, most);
    if (next != speedMPerS || !told) {
      speedMPerS = next;
      told = true;
      belt.ifPresent(each -> each.run(speedMPerS));
      if (setup.encoder() >= 0) {
        encoders.run(setup.encoder(), speedMPerS * setup.ticksPerM());
      }
    }
  }
}
