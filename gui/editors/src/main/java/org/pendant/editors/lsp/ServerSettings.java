package org.pendant.editors.lsp;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.Arrays;
import java.util.Optional;
import org.pendant.controller.ControllerOptions;
import org.pendant.editors.lsp.provider.HintSettings;
import org.pendant.models.arm.ArmLibrary;

/**
 * Server settings: what the client's settings under {@code pendant} say. What is missing there or
 * makes no sense keeps its default.
 *
 * @param hints {@code pendant.inlayHints.parameterNames}, {@code .units}, {@code .poses} and {@code
 *     .durations}
 * @param robot {@code pendant.robot}: the arm of dry runs, an id of {@link ArmLibrary}
 * @param dryRun {@code pendant.dryRun}: when programs run dry
 */
record ServerSettings(HintSettings hints, String robot, DryRunTime dryRun) {
  /** The section that they stand in. */
  static final String SECTION = "pendant";

  static final ServerSettings DEFAULT =
      new ServerSettings(HintSettings.ALL, ControllerOptions.DEFAULT_ROBOT, DryRunTime.ON_SAVE);

  /** When a program runs dry. */
  enum DryRunTime {
    OFF("off"),
    /** When it is opened and saved. */
    ON_SAVE("onSave"),
    /** When it is opened, and a second after its last change. */
    ON_CHANGE("onChange");

    private final String word;

    DryRunTime(String word) {
      this.word = word;
    }
  }

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
            flag(hints, "parameterNames"),
            flag(hints, "units"),
            flag(hints, "poses"),
            flag(hints, "durations")),
        text(own, "robot").filter(ArmLibrary.ids()::contains).orElse(DEFAULT.robot()),
        text(own, "dryRun")
            .flatMap(
                word ->
                    Arrays.stream(DryRunTime.values())
                        .filter(each -> each.word.equals(word))
                        .findFirst())
            .orElse(DEFAULT.dryRun()));
  }

  private static Optional<JsonObject> object(JsonObject in, String name) {
    return Optional.ofNullable(in.get(name))
        .filter(JsonElement::isJsonObject)
        .map(JsonElement::getAsJsonObject);
  }

  private static Optional<String> text(JsonObject in, String name) {
    return in.get(name) instanceof JsonPrimitive told && told.isString()
        ? Optional.of(told.getAsString())
        : Optional.empty();
  }

  private static boolean flag(JsonObject in, String name) {
    return !(in.get(name) instanceof JsonPrimitive told
        && told.isBoolean()
        && !told.getAsBoolean());
  }
}
