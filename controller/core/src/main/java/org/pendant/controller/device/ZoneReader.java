package org.pendant.controller.device;

import java.util.List;
import org.pendant.language.check.Nearest;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/** Zone reader: reads where a sensor sees something. */
final class ZoneReader {
  private static final Range POSITION = new Range(-10, 10, "m");
  private static final Range RADIUS = new Range(0.001, 10, "m");
  private static final double BEAM_M = 0.01;

  private ZoneReader() {}

  /** Refuses keys that a sensor of this type does not have. */
  static void allow(JsonFields fields, String type) throws JsonException {
    switch (type) {
      case "light-barrier" ->
          fields.allow(
              Nearest::among, "type", "name", "signal", "inverted", "from", "to", "radius");
      case "proximity" ->
          fields.allow(Nearest::among, "type", "name", "signal", "inverted", "at", "range");
      default -> fields.allow(Nearest::among, "type", "name", "signal", "inverted", "min", "max");
    }
  }

  static Zone zone(JsonFields fields, String type) throws JsonException {
    return switch (type) {
      case "light-barrier" ->
          new Zone.Beam(
              place(fields, "from"), place(fields, "to"), fields.number("radius", RADIUS, BEAM_M));
      case "proximity" -> new Zone.Ball(place(fields, "at"), fields.number("range", RADIUS));
      default -> area(fields);
    };
  }

  static Zone.Area area(JsonFields fields) throws JsonException {
    Zone.Place min = place(fields, "min");
    Zone.Place max = place(fields, "max");
    if (max.x() < min.x() || max.y() < min.y() || max.z() < min.z()) {
      throw fields
          .required("max")
          .place()
          .refusal("max has a number that is less than that of min, must have none");
    }
    return new Zone.Area(min, max);
  }

  private static Zone.Place place(JsonFields fields, String key) throws JsonException {
    List<Json> three = fields.numbers(key, 3);
    double[] xyz = new double[3];
    for (int i = 0; i < xyz.length; i++) {
      xyz[i] = JsonFields.number(key + "[" + i + "]", three.get(i), POSITION);
    }
    return new Zone.Place(xyz[0], xyz[1], xyz[2]);
  }
}
