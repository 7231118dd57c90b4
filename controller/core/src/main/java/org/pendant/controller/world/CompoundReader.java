package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.cell.BodyShape;
import org.pendant.language.check.Nearest;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/** Compound reader: reads an object that is put together of several solids. */
final class CompoundReader {
  /** From foam to the heaviest metal. */
  private static final Range DENSITY = new Range(1, 25_000, "kg/m^3");

  private static final String MASS = "mass";
  private static final String DENSITY_KEY = "density";
  private static final String NAME = "name";

  private final SceneReader objects;

  CompoundReader(SceneReader objects) {
    this.objects = objects;
  }

  /**
   * The object.
   *
   * @param fields of it
   */
  SceneObject read(JsonFields fields, String name, Pose pose, Material material)
      throws JsonException {
    fields.allow(Nearest::among, "type", NAME, "pose", "parts", MASS, DENSITY_KEY, "material");
    List<Json> all = fields.array("parts", BodyShape.Compound.MAX_PARTS);
    if (all.isEmpty()) {
      throw fields.required("parts").place().refusal(text("noParts", BodyShape.Compound.MAX_PARTS));
    }
    List<SceneObject> parts = new ArrayList<>();
    for (Json each : all) {
      parts.add(part(each, parts.size() + 1));
    }
    boolean whole = fields.optional(MASS).isPresent() || fields.optional(DENSITY_KEY).isPresent();
    requireOneMass(all, whole, parts);
    try {
      SceneObject.Compound still = new SceneObject.Compound(name, pose, parts, material, 0);
      return whole ? still.weighing(massKg(fields, still.volumeM3())) : still;
    } catch (IllegalArgumentException e) {
      // all parts are right by themselves: what they are together is not
      throw fields.required("parts").place().refusal(name + ": " + e.getMessage());
    }
  }

  private static void requireOneMass(List<Json> all, boolean whole, List<SceneObject> parts)
      throws JsonException {
    boolean some = parts.stream().anyMatch(part -> part.massKg() > 0);
    for (int i = 0; i < parts.size(); i++) {
      boolean has = parts.get(i).massKg() > 0;
      if (whole && has) {
        throw all.get(i).place().refusal(text("massTwice"));
      }
      if (some && !has) {
        throw all.get(i).place().refusal(text("someWithoutMass"));
      }
    }
  }

  /** The mass that is there, or that of a density. */
  private static double massKg(JsonFields fields, double volumeM3) throws JsonException {
    if (fields.optional(DENSITY_KEY).isEmpty()) {
      return fields.number(MASS, SceneRange.MASS);
    }
    Json density = fields.required(DENSITY_KEY);
    if (fields.optional(MASS).isPresent()) {
      throw density.place().refusal(text("densityAndMass"));
    }
    double massKg = fields.number(DENSITY_KEY, DENSITY) * volumeM3;
    if (!SceneRange.MASS.holds(massKg)) {
      throw density
          .place()
          .refusal(
              text(
                  "densityRange",
                  density.described(),
                  Range.number(new BigDecimal(massKg).round(new MathContext(3)).doubleValue()),
                  Range.number(SceneRange.MASS.least()),
                  Range.number(SceneRange.MASS.most())));
    }
    return massKg;
  }

  /** What a part is called that has no name. */
  static String name(int number) {
    return "part " + number;
  }

  /** A part, read as an object that has a name, and a mass where it has a density. */
  private SceneObject part(Json each, int number) throws JsonException {
    JsonFields fields = new JsonFields(each, text("aPart"));
    Json.Text type = fields.text("type");
    if (type.value().equals("plane") || type.value().equals("compound")) {
      throw type.place().refusal(text("partType", type.described()));
    }
    Optional<Json> material = fields.optional("material");
    if (material.isPresent()) {
      throw material.get().place().refusal(text("partMaterial"));
    }
    Map<String, Json.Member> members = new LinkedHashMap<>(((Json.Members) each).byKey());
    members.putIfAbsent(
        NAME, new Json.Member(new Json.Text(name(number), each.place()), each.place()));
    Json.Member density = members.remove(DENSITY_KEY);
    SceneObject part = object(members, each);
    if (density == null) {
      return part;
    }
    double massKg = massKg(fields, SceneObject.Compound.volumeM3(part));
    members.put(
        MASS,
        new Json.Member(new Json.Numeral(massKg, density.value().place()), density.keyPlace()));
    return object(members, each);
  }

  private SceneObject object(Map<String, Json.Member> members, Json each) throws JsonException {
    Json whole = new Json.Members(members, each.place());
    return objects.object(whole, new JsonFields(whole, text("aPart")));
  }
}
