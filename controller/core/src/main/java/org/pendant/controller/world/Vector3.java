package org.pendant.controller.world;

import java.util.List;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/**
 * Vector: three numbers along the axes of a frame; what they count, and which frame, is said where
 * the vector is used.
 */
public record Vector3(double x, double y, double z) {

  /** The square root of the sum of squares. */
  public double length() {
    return Math.sqrt(x * x + y * y + z * z);
  }

  /** The pose there that is turned by nothing. */
  public Pose asPose() {
    return new Pose(x, y, z, 0, 0, 0);
  }

  double[] toArray() {
    return new double[] {x, y, z};
  }

  /** The same direction with length 1. */
  Vector3 unit() {
    double length = length();
    return new Vector3(x / length, y / length, z / length);
  }

  /**
   * Checks each of the numbers.
   *
   * @param name for the message
   * @throws IllegalArgumentException if one is outside
   */
  void require(String name, Range range) {
    range.require(name + "[0]", x);
    range.require(name + "[1]", y);
    range.require(name + "[2]", z);
  }

  /** The array of three numbers that must be there under a key. */
  static Vector3 read(JsonFields fields, String key, Range range) throws JsonException {
    List<Json> three = fields.numbers(key, 3);
    return new Vector3(
        JsonFields.number(key + "[0]", three.get(0), range),
        JsonFields.number(key + "[1]", three.get(1), range),
        JsonFields.number(key + "[2]", three.get(2), range));
  }
}
