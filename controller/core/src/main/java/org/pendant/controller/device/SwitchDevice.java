package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.Optional;
import org.pendant.controller.wire.SignalLines;

/**
 * Switch device: a limit switch or a button, pressed by the tool centre point, by a body, or by
 * hand. A part of any width that is put there is the hand.
 */
final class SwitchDevice implements CellDevice {
  private final DeviceSetup.Switch setup;
  private final ZoneWatch area;
  private final SensorLine line;
  private boolean byHand;
  private boolean pressed;

  SwitchDevice(DeviceSetup.Switch setup, ZoneWatch area, SignalLines lines) {
    this.setup = setup;
    this.area = area;
    line = new SensorLine(lines, Optional.of(setup.signal()));
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return setup.kind().equals("button") ? text("button") : text("limitSwitch");
  }

  @Override
  public boolean on() {
    return pressed;
  }

  @Override
  public double maxPartWidthM() {
    return 1;
  }

  @Override
  public double partWidthM() {
    return byHand ? 1 : 0;
  }

  @Override
  public String described() {
    return kind() + " at " + setup.signal();
  }

  @Override
  public boolean putPart(double widthM) {
    byHand = widthM > 0;
    return true;
  }

  @Override
  public void step() {
    pressed = byHand || area.sees();
    line.tell(pressed != setup.inverted());
  }
}
