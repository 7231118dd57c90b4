package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.Optional;
import org.pendant.models.json.Json;

/** Object name: what an object of a scene may be called. */
final class ObjectName {
  /** Room for it in a list on a screen. */
  private static final int LONGEST = 60;

  private ObjectName() {}

  /** What is wrong with a name, if anything is. */
  static Optional<String> refusal(String name) {
    return name.isBlank()
            || name.length() > LONGEST
            || name.chars().anyMatch(Character::isISOControl)
        ? Optional.of(text("nameLength", Json.quoted(name), LONGEST))
        : Optional.empty();
  }

  /**
   * Checks a name.
   *
   * @throws IllegalArgumentException if it is empty, too long, or has letters that cannot be shown
   */
  static void require(String name) {
    Optional<String> refusal = refusal(name);
    if (refusal.isPresent()) {
      throw new IllegalArgumentException(refusal.get());
    }
  }
}
