package org.pendant.controller.device;

import java.util.Optional;
import org.pendant.controller.device.gripper.DrivenFingers;
import org.pendant.controller.device.gripper.Fingers;
import org.pendant.controller.device.gripper.PartBetween;
import org.pendant.controller.io.DigitalIo;
import org.pendant.controller.io.Signal;
import org.pendant.controller.message.MessageLog;

/** Driven device: a gripper or a door that outputs drive, with sensors at its ends. */
final class DrivenDevice implements CellDevice {
  private final DeviceSetup.Driven setup;
  private final DigitalIo io;
  private final DrivenFingers fingers;
  private final SensorLine closed;
  private final SensorLine opened;
  private final SensorLine gripped;

  DrivenDevice(DeviceSetup.Driven setup, DigitalIo io, MessageLog log) {
    this.setup = setup;
    this.io = io;
    fingers =
        new DrivenFingers(
            setup.strokeM(), setup.timeS(), text -> log.info(setup.name() + ": " + text));
    fingers.fingers().put(PartBetween.of(setup.partM()));
    closed = new SensorLine(io, setup.closed());
    opened = new SensorLine(io, setup.opened());
    gripped = new SensorLine(io, setup.gripped());
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return setup.kind();
  }

  @Override
  public boolean on() {
    return fingers.gripped();
  }

  @Override
  public double mostM() {
    return setup.kind().equals("door") ? 0 : setup.strokeM();
  }

  @Override
  public String described() {
    return setup.kind() + " that " + setup.close() + " closes";
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
    boolean close = high(setup.close());
    boolean open = setup.open().isPresent() ? high(setup.open().get()) : !close;
    fingers.step(close, open);
    closed.tell(fingers.fingers().openingM() == 0);
    opened.tell(fingers.fingers().openingM() == setup.strokeM());
    gripped.tell(fingers.gripped());
  }

  private boolean high(Signal output) {
    return io.level(output.bank(), output.index());
  }
}
