package org.pendant.controller.device;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalFields;
import org.pendant.language.check.Nearest;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/** Part reader: reads what parts come from, go to and lie on; they are objects of the scene. */
final class PartReader {
  /** Parts that all sources have at most: each is looked at in every frame. */
  static final int MAX_PARTS = 100;

  private static final int MAX_OBJECTS = 1000;
  private static final Range SPEED = new Range(-2, 2, "m/s");
  private static final Range ACCELERATION = new Range(0.01, 100, "m/s^2");
  private static final Range EVERY = new Range(0.01, 3600, "s");
  private static final Range ENCODER = new Range(0, 1, "");
  private static final Range TICKS = new Range(1, 100_000, "ticks/m");

  /** What kind of object each name stands for. */
  private enum Kind {
    BOX,
    WITH_MASS,
    OTHER
  }

  private final Map<String, Kind> objects = new HashMap<>();
  private int count;

  private PartReader() {}

  /** A reader for a scene; what is wrong with its objects is said elsewhere. */
  static PartReader of(JsonFields scene) throws JsonException {
    PartReader reader = new PartReader();
    for (Json each : scene.array("objects", MAX_OBJECTS)) {
      JsonFields fields = new JsonFields(each, "an object of the scene");
      Kind kind =
          fields.optional("mass").isPresent()
              ? Kind.WITH_MASS
              : fields.text("type").value().equals("box") ? Kind.BOX : Kind.OTHER;
      reader.objects.put(fields.text("name").value(), kind);
    }
    return reader;
  }

  DeviceSetup belt(String name, JsonFields fields) throws JsonException {
    fields.allow(
        Nearest::among,
        "type",
        "name",
        "object",
        "speed",
        "acceleration",
        "run",
        "encoder",
        "ticks");
    boolean turns = fields.optional("encoder").isPresent();
    return new DeviceSetup.Belt(
        name,
        object(fields, Kind.BOX, "a box that stands still"),
        fields.number("speed", SPEED),
        fields.number("acceleration", ACCELERATION, 1),
        signal(fields, "run"),
        turns ? whole(fields, "encoder", ENCODER) : -1,
        turns ? fields.number("ticks", TICKS) : 0);
  }

  DeviceSetup source(String name, JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "object", "every", "when", "count");
    boolean timed = fields.optional("every").isPresent();
    Optional<Signal> when = signal(fields, "when");
    if (!timed && when.isEmpty()) {
      throw fields.place().refusal("a source has neither every nor when, must have one");
    }
    int parts =
        fields.optional("count").isPresent()
            ? whole(fields, "count", new Range(1, MAX_PARTS, ""))
            : 10;
    count += parts;
    if (count > MAX_PARTS) {
      throw fields
          .place()
          .refusal("sources have " + count + " parts together, must be at most " + MAX_PARTS);
    }
    return new DeviceSetup.Source(
        name,
        object(fields, Kind.WITH_MASS, "an object with a mass"),
        timed ? fields.number("every", EVERY) : 0,
        when,
        parts);
  }

  DeviceSetup sink(String name, JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "min", "max");
    return new DeviceSetup.Sink(name, ZoneReader.area(fields));
  }

  private String object(JsonFields fields, Kind kind, String words) throws JsonException {
    Json.Text name = fields.text("object");
    if (objects.get(name.value()) != kind) {
      throw name.place()
          .refusal("object is " + name.described() + ", must be the name of " + words);
    }
    return name.value();
  }

  private static int whole(JsonFields fields, String key, Range range) throws JsonException {
    double value = fields.number(key, range);
    if (value != Math.rint(value)) {
      throw fields
          .required(key)
          .place()
          .refusal(key + " is " + Range.number(value) + ", must be a whole number");
    }
    return (int) value;
  }

  private static Optional<Signal> signal(JsonFields fields, String key) throws JsonException {
    return fields.optional(key).isPresent()
        ? Optional.of(SignalFields.signal(fields, key))
        : Optional.empty();
  }
}
