package org.pendant.editors.lsp;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.Optional;
import org.pendant.editors.lsp.provider.HintSettings;

/**
 * Server settings: what the client's settings under {@code pendant} say. What is missing there or
 * has another type keeps its default.
 *
 * @param hints {@code pendant.inlayHints.parameterNames}, {@code .units} and {@code .poses}
 */
record ServerSettings(HintSettings hints) {
  /** The section that they stand in. */
  static final String SECTION = "pendant";

  static final ServerSettings DEFAULT = new ServerSettings(HintSettings.ALL);

  /**
   * What {@code settings} say.
   *
   * @param settings as the client sends them: the section itself, or what holds it
   */
  static ServerSettings of(Object settings) {
    if (!(settings instanceof JsonElement element) || !element.isJsonObject()) {
      return DEFAULT;
    }
    JsonObject all = element.getAsJsonObject();
    JsonObject own = object(all, SECTION).orElse(all);
    JsonObject hints = object(own, "inlayHints").orElseGet(JsonObject::new);
    return new ServerSettings(
        new HintSettings(
            flag(hints, "parameterNames"), flag(hints, "units"), flag(hints, "poses")));
  }

  private static Optional<JsonObject> object(JsonObject in, String name) {
    return Optional.ofNullable(in.get(name))
        .filter(JsonElement::isJsonObject)
        .map(JsonElement::getAsJsonObject);
  }

  private static boolean flag(JsonObject in, String name) {
    return !(in.get(name) instanceof JsonPrimitive told && told.isBoolean())
        || in.get(name).getAsBoolean();
  }
}
