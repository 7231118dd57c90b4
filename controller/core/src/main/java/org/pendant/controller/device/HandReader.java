package org.pendant.controller.device;

import java.util.Optional;
import org.pendant.controller.world.HandSetup;
import org.pendant.models.json.JsonException;

/** Hand reader: reads what a gripper touches bodies with. */
final class HandReader {
  private HandReader() {}

  /** The fingertips of a gripper. */
  static Optional<HandSetup> fingers(FieldReader gripper) throws JsonException {
    FieldReader fields = gripper.group("fingers", "fingers");
    return Optional.of(
        new HandSetup(
            fields.spot("at"),
            new HandSetup.Grip.Pads(fields.number("width"), fields.number("length")),
            fields.number("friction")));
  }

  /** The cup of a vacuum gripper. */
  static Optional<HandSetup> cup(FieldReader gripper) throws JsonException {
    FieldReader fields = gripper.group("cup", "a cup");
    return Optional.of(
        new HandSetup(
            fields.spot("at"),
            new HandSetup.Grip.Cup(
                fields.number("radius"), fields.number("reach"), fields.number("force")),
            fields.number("friction")));
  }
}
