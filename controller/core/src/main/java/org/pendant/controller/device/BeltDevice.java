package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.Optional;
import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;
import org.pendant.controller.world.BeltSurface;
import org.pendant.models.time.FrameTime;

/** Belt device: carries what lies on it, and turns an encoder. */
final class BeltDevice implements CellDevice {
  private final DeviceSetup.Belt setup;
  private final Optional<BeltSurface> belt;
  private final EncoderTicks encoders;
  private final Optional<SignalLine> run;
  private double speedMPerS;
  private boolean told;

  BeltDevice(
      DeviceSetup.Belt setup,
      Optional<BeltSurface> belt,
      EncoderTicks encoders,
      SignalLines lines) {
    this.setup = setup;
    this.belt = belt;
    this.encoders = encoders;
    run = setup.run().map(lines::line);
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("belt");
  }

  @Override
  public boolean on() {
    return speedMPerS != 0;
  }

  @Override
  public String described() {
    return setup.encoder() < 0
        ? text("beltOf", setup.object())
        : text("beltWithEncoder", setup.object(), setup.encoder());
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    boolean runs = run.isEmpty() || run.get().high();
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
