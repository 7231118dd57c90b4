package org.pendant.controller.device;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.wire.CellSignal;
import org.pendant.models.json.FilePosition;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;

/** Part reader: reads what parts come from, go to and lie on; they are objects of the scene. */
final class PartReader {
  private static final String OBJECT = "object";
  private static final int MAX_OBJECTS = 1000;

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

  DeviceSetup belt(String name, FieldReader fields) throws JsonException {
    boolean turns = fields.has("encoder");
    return new DeviceSetup.Belt(
        name,
        object(fields, Kind.BOX),
        fields.number("speed"),
        fields.number("acceleration"),
        fields.wire("run"),
        turns ? (int) fields.number("encoder") : -1,
        turns ? fields.number("ticks") : 0);
  }

  DeviceSetup source(String name, FieldReader fields) throws JsonException {
    boolean timed = fields.has("every");
    Optional<CellSignal> when = fields.wire("when");
    FilePosition place = fields.all().place();
    if (!timed && when.isEmpty()) {
      throw place.refusal("a source has neither every nor when, must have one");
    }
    int parts = (int) fields.number("count");
    count += parts;
    if (count > DeviceKind.MAX_PARTS) {
      throw place.refusal(
          "sources have " + count + " parts together, must be at most " + DeviceKind.MAX_PARTS);
    }
    return new DeviceSetup.Source(
        name, object(fields, Kind.WITH_MASS), timed ? fields.number("every") : 0, when, parts);
  }

  /** Names of objects with a mass; none for all. */
  List<String> named(FieldReader fields, String key) throws JsonException {
    List<String> names = new ArrayList<>();
    for (Json each : fields.all().array(key, fields.subjects(key).most())) {
      if (!(each instanceof Json.Text name) || objects.get(name.value()) != Kind.WITH_MASS) {
        throw JsonFields.wrong(key, each, "the name of an object with a mass");
      }
      names.add(name.value());
    }
    return names;
  }

  private String object(FieldReader fields, Kind kind) throws JsonException {
    Json.Text name = fields.all().text(OBJECT);
    if (objects.get(name.value()) != kind) {
      throw name.place()
          .refusal(
              "object is "
                  + name.described()
                  + ", must be the name of "
                  + fields.subject(OBJECT).kind());
    }
    return name.value();
  }
}
