package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.Optional;
import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;
import org.pendant.models.time.FrameTime;

/**
 * Door device: what outputs close and open, with switches at its ends. It moves an object of the
 * scene, or is known by its switches alone.
 */
final class DoorDevice implements CellDevice {
  private final DeviceSetup.Door setup;
  private final Optional<DoorDrive> drive;
  private final SignalLine close;
  private final Optional<SignalLine> open;
  private final SensorLine closed;
  private final SensorLine opened;
  private boolean closes;
  private double openShare = 1;

  DoorDevice(DeviceSetup.Door setup, Optional<DoorDrive> drive, SignalLines lines) {
    this.setup = setup;
    this.drive = drive;
    close = lines.line(setup.close());
    open = setup.open().map(lines::line);
    closed = new SensorLine(lines, setup.closed());
    opened = new SensorLine(lines, setup.opened());
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("door");
  }

  @Override
  public boolean on() {
    return false;
  }

  @Override
  public double strokeM() {
    return 1;
  }

  @Override
  public double openingM() {
    return openShare;
  }

  @Override
  public String described() {
    return setup
        .leaf()
        .map(leaf -> text("doorWithLeaf", leaf.object(), setup.close()))
        .orElseGet(() -> text("doorOf", setup.close()));
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  /** Driven both ways or none it goes on as before. */
  @Override
  public void step() {
    boolean toClose = close.high();
    boolean toOpen = open.isPresent() ? open.get().high() : !toClose;
    if (toClose != toOpen) {
      closes = toClose;
    }
    if (drive.isPresent()) {
      drive.get().step(closes);
      openShare = drive.get().openShare();
    } else {
      double way = FrameTime.FRAME_S / setup.timeS();
      openShare = closes ? Math.max(0, openShare - way) : Math.min(1, openShare + way);
    }
    closed.tell(openShare == 0);
    opened.tell(openShare == 1);
  }
}
