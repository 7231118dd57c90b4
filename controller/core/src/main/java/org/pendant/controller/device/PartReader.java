package org.pendant.controller.device;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.cell.BodyRail;
import org.pendant.controller.wire.CellSignal;
import org.pendant.models.json.FilePosition;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/** Part reader: reads what parts come from, go to and lie on; they are objects of the scene. */
final class PartReader {
  private static final String OBJECT = "object";
  private static final String ALONG = "along";
  private static final int MAX_OBJECTS = 1000;
  private static final double MIN_DIRECTION = 0.001;

  /** What kind of object each name stands for. */
  private enum Kind {
    BOX,
    WITH_MASS,
    OTHER
  }

  private final Map<String, Kind> objects = new HashMap<>();

  private final Set<String> railed = new HashSet<>();
  private final Set<String> sourced = new HashSet<>();

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
    String object = object(fields, Kind.WITH_MASS);
    if (railed.contains(object)) {
      throw place.refusal("object is " + Json.quoted(object) + ", which is on a rail");
    }
    sourced.add(object);
    return new DeviceSetup.Source(name, object, timed ? fields.number("every") : 0, when, parts);
  }

  DeviceSetup rail(String name, FieldReader fields) throws JsonException {
    String object = object(fields, Kind.WITH_MASS);
    Json.Text of = fields.all().text(OBJECT);
    if (sourced.contains(object)) {
      throw of.place().refusal("object is " + of.described() + ", which a source has");
    }
    if (!railed.add(object)) {
      throw of.place().refusal("object is " + of.described() + ", which is on a rail already");
    }
    Zone.Place along = fields.place(ALONG);
    double length =
        Math.sqrt(along.x() * along.x() + along.y() * along.y() + along.z() * along.z());
    if (length < MIN_DIRECTION) {
      throw fields
          .all()
          .required(ALONG)
          .place()
          .refusal(
              "along is ["
                  + Range.number(along.x())
                  + ", "
                  + Range.number(along.y())
                  + ", "
                  + Range.number(along.z())
                  + "], must have a length of at least "
                  + MIN_DIRECTION);
    }
    return new DeviceSetup.Rail(
        name,
        object,
        new BodyRail.Line(
            along.x() / length,
            along.y() / length,
            along.z() / length,
            fields.number("travel"),
            fields.number("friction"),
            fields.number("damping")),
        fields.wire("closed"),
        fields.wire("opened"));
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
