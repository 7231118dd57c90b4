package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.Optional;
import org.pendant.controller.device.gripper.DrivenFingers;
import org.pendant.controller.device.gripper.Fingers;
import org.pendant.controller.device.gripper.PartBetween;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;

/** Driven device: a gripper that outputs drive, with sensors at its ends. */
final class DrivenDevice implements CellDevice {
  private final DeviceSetup.Driven setup;
  private final SignalLine close;
  private final Optional<SignalLine> open;
  private final DrivenFingers fingers;
  private final SensorLine closed;
  private final SensorLine opened;
  private final SensorLine gripped;

  DrivenDevice(DeviceSetup.Driven setup, SignalLines lines, MessageLog log) {
    this.setup = setup;
    close = lines.line(setup.close());
    open = setup.open().map(lines::line);
    fingers = new DrivenFingers(setup.name(), setup.strokeM(), setup.timeS(), log::info);
    fingers.fingers().put(PartBetween.of(setup.partWidthM()));
    closed = new SensorLine(lines, setup.closed());
    opened = new SensorLine(lines, setup.opened());
    gripped = new SensorLine(lines, setup.gripped());
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("gripper");
  }

  @Override
  public boolean on() {
    return fingers.gripped();
  }

  @Override
  public double maxPartWidthM() {
    return setup.strokeM();
  }

  @Override
  public String described() {
    return text("drivenGripper", setup.close());
  }

  @Override
  public Optional<Fingers> fingers() {
    return Optional.of(fingers.fingers());
  }

  @Override
  public boolean putPart(double widthM) {
    fingers.fingers().put(PartBetween.of(widthM));
    return true;
  }

  @Override
  public void step() {
    boolean closes = close.high();
    fingers.step(closes, open.isPresent() ? open.get().high() : !closes);
    closed.tell(fingers.fingers().openingM() == 0);
    opened.tell(fingers.fingers().openingM() == setup.strokeM());
    gripped.tell(fingers.gripped());
  }
}
