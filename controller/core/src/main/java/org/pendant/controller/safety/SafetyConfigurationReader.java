package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.check.Nearest;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;
import org.pendant.models.json.Range;

/**
 * Safety configuration reader: reads one from JSON; docs/safety.md describes the file. What it
 * leaves out is as {@link SafetyConfiguration#standard}.
 */
public final class SafetyConfigurationReader {
  private static final Range POINT = new Range(-10, 10, "m");
  private static final Range DIRECTION = new Range(-1000, 1000, "");
  private static final Range ANGLE = new Range(0.001, 3.141, "rad");

  private SafetyConfigurationReader() {}

  /**
   * Reads all of {@code in}, which the caller closes.
   *
   * @param fileName for messages
   * @param arm whose standard holds for what is left out
   * @throws JsonException for the first thing that is wrong, with its place; also if the file
   *     cannot be read or is too large
   */
  public static SafetyConfiguration read(String fileName, InputStream in, ArmDescription arm)
      throws JsonException {
    Json root = JsonFile.read(fileName, in);
    JsonFields fields = new JsonFields(root, text("aSafetyConfiguration"));
    fields.allow(Nearest::among, "normal", "reduced", "planes", "toolDirection");
    SafetyLimits standard = StandardLimits.normal(arm);
    SafetyLimits normal = limits(fields.optional("normal"), text("theNormalLimits"), standard);
    SafetyLimits reduced =
        limits(
            fields.optional("reduced"),
            text("theReducedLimits"),
            StandardLimits.reduced(standard).tighterOf(normal));
    List<SafetyPlane> planes = new ArrayList<>();
    for (Json each : fields.array("planes", SafetyConfiguration.MAX_PLANES)) {
      planes.add(plane(each));
    }
    Optional<Json> direction = fields.optional("toolDirection");
    Optional<ToolDirection> toolDirection =
        direction.isPresent() ? Optional.of(toolDirection(direction.get())) : Optional.empty();
    requireWithin(normal, reduced, fields.optional("reduced").orElse(root));
    try {
      return new SafetyConfiguration(normal, reduced, planes, toolDirection);
    } catch (IllegalArgumentException e) {
      throw fields.optional("planes").orElse(root).place().refusal(e.getMessage());
    }
  }

  private static void requireWithin(SafetyLimits normal, SafetyLimits reduced, Json blamed)
      throws JsonException {
    try {
      reduced.requireWithin(normal);
    } catch (IllegalArgumentException e) {
      throw blamed.place().refusal(e.getMessage());
    }
  }

  private static SafetyLimits limits(Optional<Json> value, String what, SafetyLimits standard)
      throws JsonException {
    return value.isPresent()
        ? LimitsReader.read(new JsonFields(value.get(), what), standard)
        : standard;
  }

  private static SafetyPlane plane(Json value) throws JsonException {
    JsonFields fields = new JsonFields(value, text("aPlane"));
    fields.allow(Nearest::among, "name", "pointM", "allowedSide", "applies", "elbow");
    Json.Text name = fields.text("name");
    double[] point = three(fields, "pointM", POINT);
    Axis side = axis(fields, "allowedSide");
    Applies applies = applies(fields, Applies.values());
    boolean elbow = flag(fields, "elbow");
    try {
      return new SafetyPlane(name.value(), point[0], point[1], point[2], side, applies, elbow);
    } catch (IllegalArgumentException e) {
      throw name.place().refusal(e.getMessage());
    }
  }

  private static ToolDirection toolDirection(Json value) throws JsonException {
    JsonFields fields = new JsonFields(value, text("aToolDirection"));
    fields.allow(Nearest::among, "allowedInBase", "toolInFlange", "largestAngleRad", "applies");
    return new ToolDirection(
        axis(fields, "allowedInBase"),
        fields.optional("toolInFlange").isPresent()
            ? axis(fields, "toolInFlange")
            : new Axis(0, 0, 1),
        fields.number("largestAngleRad", ANGLE),
        applies(fields, Applies.NORMAL, Applies.REDUCED, Applies.BOTH));
  }

  private static double[] three(JsonFields fields, String key, Range range) throws JsonException {
    List<Json> values = fields.numbers(key, 3);
    double[] three = new double[3];
    for (int i = 0; i < three.length; i++) {
      three[i] = JsonFields.number(key + "[" + i + "]", values.get(i), range);
    }
    return three;
  }

  private static Axis axis(JsonFields fields, String key) throws JsonException {
    double[] three = three(fields, key, DIRECTION);
    try {
      return new Axis(three[0], three[1], three[2]);
    } catch (IllegalArgumentException e) {
      throw fields.required(key).place().refusal(key + ": " + e.getMessage());
    }
  }

  private static Applies applies(JsonFields fields, Applies... allowed) throws JsonException {
    if (fields.optional("applies").isEmpty()) {
      return Applies.BOTH;
    }
    Json.Text text = fields.text("applies");
    List<String> words = new ArrayList<>();
    for (Applies each : allowed) {
      if (each.word().equals(text.value())) {
        return each;
      }
      words.add(each.word());
    }
    throw JsonFields.wrong("applies", text, text("oneOf", String.join(", ", words)));
  }

  private static boolean flag(JsonFields fields, String key) throws JsonException {
    Optional<Json> value = fields.optional(key);
    if (value.isEmpty()) {
      return false;
    }
    if (value.get() instanceof Json.Word word && !word.word().equals("null")) {
      return word.word().equals("true");
    }
    throw JsonFields.wrong(key, value.get(), text("trueOrFalse"));
  }
}
