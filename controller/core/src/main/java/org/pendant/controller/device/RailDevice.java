package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.Optional;
import org.pendant.cell.BodyGuide;
import org.pendant.controller.wire.SignalLines;

/** Rail device: guides an object along a line, with switches at its ends. */
final class RailDevice implements CellDevice {
  /** How near an end counts as there, m. */
  private static final double AT_END_M = 0.001;

  private final DeviceSetup.Rail setup;
  private final Optional<BodyGuide> rail;
  private final SensorLine closed;
  private final SensorLine opened;

  RailDevice(DeviceSetup.Rail setup, Optional<BodyGuide> rail, SignalLines lines) {
    this.setup = setup;
    this.rail = rail;
    closed = new SensorLine(lines, setup.closed());
    opened = new SensorLine(lines, setup.opened());
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("rail");
  }

  /** Whether it is not where it was at first. */
  @Override
  public boolean on() {
    return placeM() > AT_END_M;
  }

  @Override
  public double strokeM() {
    return setup.travelM();
  }

  /** Where the object is, in tenths of a millimetre: what trembles less is at rest. */
  @Override
  public double openingM() {
    return Math.rint(1e4 * Math.clamp(placeM(), 0, setup.travelM())) / 1e4;
  }

  private double placeM() {
    return rail.map(BodyGuide::place).orElse(0.0);
  }

  @Override
  public String described() {
    return text("railOf", setup.object());
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    closed.tell(placeM() <= AT_END_M);
    opened.tell(placeM() >= setup.travelM() - AT_END_M);
  }
}
