package org.pendant.models.arm;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;

/** The arm models that come with the program. Descriptions are data, one JSON file each. */
public final class ArmLibrary {
  private static final List<String> IDS =
      List.of(
          "ur3", "ur5", "ur10", "ur3e", "ur5e", "ur7e", "ur10e", "ur12e", "ur16e", "ur8long",
          "ur15", "ur18", "ur20", "ur30");

  private ArmLibrary() {}

  /** The known models, oldest series and smallest arm first. */
  public static List<String> ids() {
    return IDS;
  }

  /**
   * Reads the description of a model.
   *
   * @throws IllegalArgumentException if there is no model of this id; the message names those there
   *     are
   */
  public static ArmDescription load(String id) {
    if (!IDS.contains(id)) {
      throw new IllegalArgumentException(
          "robot: '" + id + "' is not known, must be one of " + String.join(", ", IDS));
    }
    String file = id.concat(".json");
    try (InputStream in = ArmLibrary.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalStateException(file + " is missing from this build");
      }
      return new DescriptionReader(file, in).read();
    } catch (IOException e) {
      throw new UncheckedIOException(file + " cannot be read", e);
    }
  }
}
