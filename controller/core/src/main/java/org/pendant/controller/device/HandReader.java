package org.pendant.controller.device;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.world.HandSetup;
import org.pendant.language.check.Nearest;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/** Hand reader: reads what a gripper touches bodies with. */
final class HandReader {
  private static final Range POSITION = new Range(-4, 4, "m");
  private static final Range ROTATION = new Range(-100, 100, "rad");

  private HandReader() {}

  /** The fingertips of a gripper. */
  static Optional<HandSetup> fingers(JsonFields gripper) throws JsonException {
    Optional<Json> value = gripper.optional("fingers");
    if (value.isEmpty()) {
      return Optional.of(HandSetup.FINGERS);
    }
    JsonFields fields = new JsonFields(value.get(), "fingers");
    fields.allow(Nearest::among, "at", "width", "length", "friction");
    HandSetup.Grip.Pads plain = HandSetup.Grip.Pads.DEFAULT;
    return Optional.of(
        new HandSetup(
            at(fields),
            new HandSetup.Grip.Pads(
                fields.number("width", HandSetup.LENGTH, plain.widthM()),
                fields.number("length", HandSetup.LENGTH, plain.lengthM())),
            friction(fields)));
  }

  /** The cup of a vacuum gripper. */
  static Optional<HandSetup> cup(JsonFields gripper) throws JsonException {
    Optional<Json> value = gripper.optional("cup");
    if (value.isEmpty()) {
      return Optional.of(HandSetup.CUP);
    }
    JsonFields fields = new JsonFields(value.get(), "a cup");
    fields.allow(Nearest::among, "at", "radius", "reach", "force", "friction");
    HandSetup.Grip.Cup plain = HandSetup.Grip.Cup.DEFAULT;
    return Optional.of(
        new HandSetup(
            at(fields),
            new HandSetup.Grip.Cup(
                fields.number("radius", HandSetup.LENGTH, plain.radiusM()),
                fields.number("reach", HandSetup.LENGTH, plain.reachM()),
                fields.number("force", HandSetup.FORCE, plain.forceN())),
            friction(fields)));
  }

  private static double friction(JsonFields fields) throws JsonException {
    return fields.number("friction", HandSetup.FRICTION, HandSetup.RUBBER);
  }

  private static Optional<Pose> at(JsonFields fields) throws JsonException {
    if (fields.optional("at").isEmpty()) {
      return Optional.empty();
    }
    List<Json> six = fields.numbers("at", Pose.SIZE);
    double[] pose = new double[Pose.SIZE];
    for (int i = 0; i < pose.length; i++) {
      pose[i] = JsonFields.number("at[" + i + "]", six.get(i), i < 3 ? POSITION : ROTATION);
    }
    return Optional.of(Pose.of(pose));
  }
}
