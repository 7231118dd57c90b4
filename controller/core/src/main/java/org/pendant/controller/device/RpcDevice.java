package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.device.gripper.Fingers;
import org.pendant.controller.device.gripper.GripProcedures;
import org.pendant.controller.device.gripper.PartBetween;
import org.pendant.controller.message.MessageLog;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** RPC device: a gripper that is worked by remote procedures. */
final class RpcDevice implements CellDevice {
  private final String name;
  private final String kind;
  private final GripProcedures gripper;

  RpcDevice(DeviceSetup.RpcGripper setup, MessageLog log) {
    name = setup.name();
    kind = setup.kind();
    gripper =
        new GripProcedures(
            name,
            kind.equals("rg") ? GripProcedures.Make.RG : GripProcedures.Make.TWO_FG,
            log::info);
    gripper.fingers().put(PartBetween.of(setup.partWidthM()));
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public String kind() {
    return text("rpcGripper", kind);
  }

  @Override
  public boolean on() {
    return gripper.gripped();
  }

  @Override
  public String described() {
    return text("rpcGripperAt", kind, GripProcedures.PORT);
  }

  @Override
  public OptionalInt procedurePort() {
    return OptionalInt.of(GripProcedures.PORT);
  }

  @Override
  public Optional<Value> call(String method, List<Value> arguments) throws ScriptError {
    return gripper.call(method, arguments);
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
