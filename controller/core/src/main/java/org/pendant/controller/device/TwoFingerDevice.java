package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.device.gripper.AdaptiveGripper;
import org.pendant.controller.device.gripper.Fingers;
import org.pendant.controller.device.gripper.GripperLines;
import org.pendant.controller.device.gripper.PartBetween;
import org.pendant.controller.device.gripper.RtuLine;
import org.pendant.controller.external.DeviceTalk;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.io.Signals;
import org.pendant.controller.message.MessageLog;

/** Two-finger device: an adaptive gripper at the socket of its driver, or on the tool's line. */
final class TwoFingerDevice implements CellDevice {
  private static final int BAUD = 115_200;

  private final String name;
  private final boolean atTool;
  private final Signals signals;
  private final MessageLog log;
  private final AdaptiveGripper gripper;
  private final GripperLines.Station station = new GripperLines.Station();

  TwoFingerDevice(DeviceSetup.TwoFinger setup, Signals signals, MessageLog log) {
    name = setup.name();
    atTool = setup.atTool();
    this.signals = signals;
    this.log = log;
    gripper = new AdaptiveGripper(name, setup.activated(), log::info);
    gripper.fingers().put(PartBetween.of(setup.partWidthM()));
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public String kind() {
    return text("twoFingerGripper");
  }

  @Override
  public boolean on() {
    return gripper.holds();
  }

  @Override
  public String described() {
    boolean active = gripper.active();
    return atTool
        ? text(active ? "twoFingerAtTool" : "twoFingerAtToolNotActivated", RtuLine.PORT)
        : text(active ? "twoFingerAtSocket" : "twoFingerAtSocketNotActivated", GripperLines.PORT);
  }

  @Override
  public OptionalInt port() {
    return OptionalInt.of(atTool ? RtuLine.PORT : GripperLines.PORT);
  }

  @Override
  public DeviceTalk connect() {
    return atTool
        ? new RtuLine(gripper, this::lineIsOn)
        : new GripperLines(gripper, station, log::warnOnce);
  }

  private boolean lineIsOn() {
    ToolCommunication line = signals.tool().communication();
    if (!line.enabled()) {
      log.warnOnce(text("toolLineOff", name));
      return false;
    }
    if (line.baudRate() != BAUD || line.parity() != ToolCommunication.Parity.NONE) {
      log.warnOnce(text("toolLineSettings", name, line.baudRate(), line.parity().number(), BAUD));
      return false;
    }
    return true;
  }

  @Override
  public Optional<Fingers> fingers() {
    return Optional.of(gripper.fingers());
  }

  @Override
  public boolean putPart(double widthM) {
    gripper.fingers().put(PartBetween.of(widthM));
    return true;
  }

  @Override
  public void step() {
    gripper.step();
  }
}
