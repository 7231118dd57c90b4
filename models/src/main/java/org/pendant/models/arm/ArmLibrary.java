package org.pendant.models.arm;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;

/**
 * Arm library: the models that come with the program. Descriptions are data, one JSON file each.
 */
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
   * The id of the model that people call {@code name}: its id or display name, in capitals or not,
   * with or without blanks. {@code UR8 Long} is {@code ur8long}.
   */
  public static Optional<String> find(String name) {
    // An id is the display name in lower case without its blanks.
    String id = name.replace(" ", "").toLowerCase(Locale.ROOT);
    return IDS.contains(id) ? Optional.of(id) : Optional.empty();
  }

  /**
   * As {@link #find}, for a name that must be known.
   *
   * @throws IllegalArgumentException if there is no such model; the message names those there are
   */
  public static String idOf(String name) {
    Optional<String> id = find(name);
    if (id.isEmpty()) {
      throw new IllegalArgumentException(
          "robot: '" + name + "' is not known, must be one of " + String.join(", ", IDS));
    }
    return id.get();
  }

  /**
   * Reads the description of a model.
   *
   * @param name as {@link #find} understands it
   * @throws IllegalArgumentException if there is no such model; the message names those there are
   */
  public static ArmDescription load(String name) {
    String file = idOf(name).concat(".json");
    try {
      Json root = JsonFile.ofResource(ArmLibrary.class, file);
      return DescriptionReader.read(new JsonFields(root, "an arm"));
    } catch (JsonException e) {
      throw new IllegalStateException(file + " is no arm: " + e.getMessage(), e);
    }
  }
}
