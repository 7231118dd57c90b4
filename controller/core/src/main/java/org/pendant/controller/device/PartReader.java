package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.cell.BodyHinge;
import org.pendant.cell.BodyRail;
import org.pendant.cell.BodyShape;
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
  private static final double MIN_LENGTH = 0.001;
  private static final double MAX_TRAVEL_M = 10;

  /** Beyond, it would not be known which way it has turned. */
  private static final double MAX_TURN_RAD = 3;

  /** What kind of object each name stands for. */
  private enum Kind {
    BOX,
    WITH_MASS,
    OTHER
  }

  private final Map<String, Kind> objects = new HashMap<>();

  private final Set<String> guided = new HashSet<>();
  private final Set<String> sourced = new HashSet<>();

  private int count;

  private PartReader() {}

  /** A reader for a scene; what is wrong with its objects is said elsewhere. */
  static PartReader of(JsonFields scene) throws JsonException {
    PartReader reader = new PartReader();
    for (Json each : scene.array("objects", MAX_OBJECTS)) {
      JsonFields fields = new JsonFields(each, text("sceneObject"));
      Kind kind =
          hasMass(fields)
              ? Kind.WITH_MASS
              : fields.text("type").value().equals("box") ? Kind.BOX : Kind.OTHER;
      reader.objects.put(fields.text("name").value(), kind);
    }
    return reader;
  }

  private static boolean hasMass(JsonFields object) throws JsonException {
    if (object.optional("mass").isPresent() || object.optional("density").isPresent()) {
      return true;
    }
    for (Json each : object.array("parts", BodyShape.Compound.MAX_PARTS)) {
      if (hasMass(new JsonFields(each, text("aPart")))) {
        return true;
      }
    }
    return false;
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
      throw place.refusal(text("sourceWithoutCause"));
    }
    int parts = (int) fields.number("count");
    count += parts;
    if (count > DeviceKind.MAX_PARTS) {
      throw place.refusal(text("tooManyParts", count, DeviceKind.MAX_PARTS));
    }
    String object = object(fields, Kind.WITH_MASS);
    if (guided.contains(object)) {
      throw place.refusal(text("objectGuided", Json.quoted(object)));
    }
    sourced.add(object);
    return new DeviceSetup.Source(name, object, timed ? fields.number("every") : 0, when, parts);
  }

  DeviceSetup rail(String name, FieldReader fields) throws JsonException {
    String object = guided(fields);
    Zone.Place along = fields.vector(ALONG);
    double length = length(fields, ALONG, along, Double.POSITIVE_INFINITY);
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

  /** What a door moves, where that is an object. */
  Optional<DoorLeaf> leaf(FieldReader fields) throws JsonException {
    boolean slides = fields.has("slides");
    boolean turns = fields.has("turns");
    JsonFields all = fields.all();
    if (!fields.has(OBJECT)) {
      for (String key : List.of("slides", "turns", "hinge", "force", "torque")) {
        if (fields.has(key)) {
          throw all.required(key).place().refusal(text("fieldWithoutObject", key));
        }
      }
      return Optional.empty();
    }
    if (slides == turns) {
      throw all.required(OBJECT)
          .place()
          .refusal(text(slides ? "doorSlidesAndTurns" : "doorNeitherWay"));
    }
    for (String key : slides ? List.of("hinge", "torque") : List.of("force")) {
      if (fields.has(key)) {
        throw all.required(key).place().refusal(text(slides ? "doorSlides" : "doorTurns", key));
      }
    }
    String object = guided(fields);
    return Optional.of(slides ? slide(object, fields) : turn(object, fields));
  }

  private static DoorLeaf slide(String object, FieldReader fields) throws JsonException {
    Zone.Place way = fields.vector("slides");
    double travelM = length(fields, "slides", way, MAX_TRAVEL_M);
    return new DoorLeaf.Slide(
        object,
        new BodyRail.Line(
            way.x() / travelM,
            way.y() / travelM,
            way.z() / travelM,
            travelM,
            fields.number("force"),
            0));
  }

  private static DoorLeaf turn(String object, FieldReader fields) throws JsonException {
    Zone.Place hinge = fields.place("hinge");
    Zone.Place turn = fields.vector("turns");
    double angleRad = length(fields, "turns", turn, MAX_TURN_RAD);
    return new DoorLeaf.Turn(
        object,
        new BodyHinge.Axis(
            hinge.x(),
            hinge.y(),
            hinge.z(),
            turn.x() / angleRad,
            turn.y() / angleRad,
            turn.z() / angleRad,
            angleRad,
            fields.number("torque")));
  }

  /** An object that nothing else guides or makes copies of. */
  private String guided(FieldReader fields) throws JsonException {
    String object = object(fields, Kind.WITH_MASS);
    Json.Text of = fields.all().text(OBJECT);
    if (sourced.contains(object)) {
      throw of.place().refusal(text("objectOfSource", of.described()));
    }
    if (!guided.add(object)) {
      throw of.place().refusal(text("objectGuided", of.described()));
    }
    return object;
  }

  private static double length(FieldReader fields, String key, Zone.Place of, double most)
      throws JsonException {
    double length = Math.sqrt(of.x() * of.x() + of.y() * of.y() + of.z() * of.z());
    if (length < MIN_LENGTH || length > most) {
      throw fields
          .all()
          .required(key)
          .place()
          .refusal(
              most < Double.POSITIVE_INFINITY
                  ? text(
                      "lengthRange",
                      key,
                      Range.number(of.x()),
                      Range.number(of.y()),
                      Range.number(of.z()),
                      MIN_LENGTH,
                      Range.number(most))
                  : text(
                      "lengthLeast",
                      key,
                      Range.number(of.x()),
                      Range.number(of.y()),
                      Range.number(of.z()),
                      MIN_LENGTH));
    }
    return length;
  }

  /** Names of objects with a mass; none for all. */
  List<String> named(FieldReader fields, String key) throws JsonException {
    List<String> names = new ArrayList<>();
    for (Json each : fields.all().array(key, fields.subjects(key).most())) {
      if (!(each instanceof Json.Text name) || objects.get(name.value()) != Kind.WITH_MASS) {
        throw JsonFields.wrong(key, each, text("nameOfObjectWithMass"));
      }
      names.add(name.value());
    }
    return names;
  }

  private String object(FieldReader fields, Kind kind) throws JsonException {
    Json.Text name = fields.all().text(OBJECT);
    if (objects.get(name.value()) != kind) {
      throw name.place()
          .refusal(text("unknownObject", name.described(), fields.subject(OBJECT).kind()));
    }
    return name.value();
  }
}
