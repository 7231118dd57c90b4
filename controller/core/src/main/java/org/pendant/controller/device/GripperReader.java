package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.Optional;
import org.pendant.controller.world.GripperSetup;
import org.pendant.models.json.JsonException;

/** Gripper reader: reads what a gripper touches bodies with. */
final class GripperReader {
  private GripperReader() {}

  /** The fingertips of a gripper. */
  static Optional<GripperSetup> fingers(FieldReader gripper) throws JsonException {
    FieldReader fields = gripper.group("fingers", "fingers");
    return Optional.of(
        new GripperSetup(
            fields.spot("at"),
            new GripperSetup.Grip.Pads(fields.number("width"), fields.number("length")),
            fields.number("friction")));
  }

  /** The cup of a vacuum gripper. */
  static Optional<GripperSetup> cup(FieldReader gripper) throws JsonException {
    FieldReader fields = gripper.group("cup", text("aCup"));
    return Optional.of(
        new GripperSetup(
            fields.spot("at"),
            new GripperSetup.Grip.Cup(
                fields.number("radius"), fields.number("reach"), fields.number("force")),
            fields.number("friction")));
  }
}
