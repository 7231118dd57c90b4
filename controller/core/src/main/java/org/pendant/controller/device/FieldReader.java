package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.pendant.controller.wire.CellSignal;
import org.pendant.controller.wire.CellSignalNames;
import org.pendant.language.check.Nearest;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/** Field reader: reads fields as they are declared. */
final class FieldReader {
  private static final int AXES = 3;

  private final List<DeviceField> declared;
  private final JsonFields fields;
  private final CellSignalNames signals;

  /**
   * Those of an object.
   *
   * @param signals what wires may lead to
   * @param others keys that it may have besides
   * @throws JsonException for a key that it may not have
   */
  FieldReader(
      List<DeviceField> declared, JsonFields fields, CellSignalNames signals, String... others)
      throws JsonException {
    this.signals = signals;
    this.declared = declared.stream().flatMap(FieldReader::withKeys).toList();
    this.fields = fields;
    List<String> keys = new ArrayList<>(List.of(others));
    this.declared.forEach(each -> keys.add(each.key()));
    fields.allow(Nearest::among, keys.toArray(String[]::new));
  }

  private static Stream<DeviceField> withKeys(DeviceField field) {
    return field instanceof DeviceField.Choice choice
        ? choice.ways().stream().flatMap(way -> way.fields().stream())
        : Stream.of(field);
  }

  private <F extends DeviceField> F declared(String key, Class<F> as) {
    for (DeviceField each : declared) {
      if (each.key().equals(key)) {
        return as.cast(each);
      }
    }
    throw new IllegalStateException("no field is called " + key);
  }

  boolean flag(String key) throws JsonException {
    DeviceField.Flag flag = declared(key, DeviceField.Flag.class);
    return fields.optional(key).isEmpty() ? flag.standing() : fields.flag(key);
  }

  /** What messages are about that no field is to blame for. */
  JsonFields all() {
    return fields;
  }

  boolean has(String key) {
    return fields.optional(key).isPresent();
  }

  /** A number that must be there, or has a value where it is not. */
  double number(String key) throws JsonException {
    return number(key, declared(key, DeviceField.Amount.class).range().most());
  }

  /** As {@link #number(String)}, with a bound that depends on other fields. */
  double number(String key, double most) throws JsonException {
    DeviceField.Amount amount = declared(key, DeviceField.Amount.class);
    Range range = new Range(amount.range().least(), most, amount.range().unit());
    double number =
        amount.standing().isPresent()
            ? fields.number(key, range, amount.standing().getAsDouble())
            : fields.number(key, range);
    if (amount.whole() && number != Math.rint(number)) {
      throw fields.required(key).place().refusal(text("mustBeWhole", key, Range.number(number)));
    }
    return number;
  }

  /** A text that must be there. */
  Json.Text words(String key) throws JsonException {
    return fields.text(declared(key, DeviceField.Words.class).key());
  }

  /** Numbers by their names, each with its place; none where there are none. */
  Map<String, Json> values(String key) throws JsonException {
    Json value = fields.optional(declared(key, DeviceField.Values.class).key()).orElse(null);
    if (value == null) {
      return Map.of();
    }
    if (!(value instanceof Json.Members members)) {
      throw JsonFields.wrong(key, value, text("objectOfNumbers"));
    }
    Map<String, Json> values = new LinkedHashMap<>();
    members.byKey().forEach((name, member) -> values.put(name, member.value()));
    return values;
  }

  /** A whole number that may be left out. */
  OptionalInt whole(String key) throws JsonException {
    return has(key) ? OptionalInt.of((int) number(key)) : OptionalInt.empty();
  }

  /** A signal that must be there. */
  CellSignal signal(String key) throws JsonException {
    return signals.digital(fields, key, declared(key, DeviceField.Wire.class).input());
  }

  /** A signal that may be left out. */
  Optional<CellSignal> wire(String key) throws JsonException {
    return fields.optional(key).isPresent() ? Optional.of(signal(key)) : Optional.empty();
  }

  Zone.Place place(String key) throws JsonException {
    return three(key, declared(key, DeviceField.Place.class).range());
  }

  /** Three numbers that are no place. */
  Zone.Place vector(String key) throws JsonException {
    return three(key, declared(key, DeviceField.Direction.class).range());
  }

  private Zone.Place three(String key, Range range) throws JsonException {
    List<Json> three = fields.numbers(key, AXES);
    double[] xyz = new double[AXES];
    for (int i = 0; i < AXES; i++) {
      xyz[i] = JsonFields.number(key + "[" + i + "]", three.get(i), range);
    }
    return new Zone.Place(xyz[0], xyz[1], xyz[2]);
  }

  /** A box along the axes, from its least corner to its greatest one. */
  Zone.Area area(String least, String greatest) throws JsonException {
    Zone.Place min = place(least);
    Zone.Place max = place(greatest);
    if (max.x() < min.x() || max.y() < min.y() || max.z() < min.z()) {
      throw fields.required(greatest).place().refusal(text("areaOrder", greatest, least));
    }
    return new Zone.Area(min, max);
  }

  /** What is declared of an object of the scene. */
  DeviceField.Subject subject(String key) {
    return declared(key, DeviceField.Subject.class);
  }

  /** What is declared of several objects of the scene. */
  DeviceField.Subjects subjects(String key) {
    return declared(key, DeviceField.Subjects.class);
  }

  /** A pose that may be left out. */
  Optional<Pose> spot(String key) throws JsonException {
    DeviceField.Spot spot = declared(key, DeviceField.Spot.class);
    if (fields.optional(key).isEmpty()) {
      return Optional.empty();
    }
    List<Json> six = fields.numbers(key, Pose.SIZE);
    double[] pose = new double[Pose.SIZE];
    for (int i = 0; i < pose.length; i++) {
      Range range = i < AXES ? spot.position() : spot.rotation();
      pose[i] = JsonFields.number(key + "[" + i + "]", six.get(i), range);
    }
    return Optional.of(Pose.of(pose));
  }

  /**
   * The fields of a group, which may be left out: they are what holds then.
   *
   * @param what it is called in messages
   */
  FieldReader group(String key, String what) throws JsonException {
    DeviceField.Group group = declared(key, DeviceField.Group.class);
    Json nothing = new Json.Members(Map.of(), fields.place());
    return new FieldReader(
        group.fields(), new JsonFields(fields.optional(key).orElse(nothing), what), signals);
  }
}
