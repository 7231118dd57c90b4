package org.pendant.desktop.cell;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.pendant.controller.device.DeviceKind;
import org.pendant.controller.world.Vector3;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFile;
import org.pendant.models.json.JsonValues;
import org.pendant.models.pose.Pose;

/**
 * Device text: a device as the file of a scene says it; immutable.
 *
 * @param members each value as JSON, by key, in the order of the file
 */
record DeviceText(Map<String, String> members) {
  private static final String TYPE = "type";
  private static final String NAME = "name";
  private static final int AXES = 3;
  private static final Pattern NAMED_NUMBER = Pattern.compile("(\\w+\\[\\d+\\]) *= *(-?\\d{1,9})");

  /** Copies the members. */
  DeviceText {
    members = Collections.unmodifiableMap(new LinkedHashMap<>(members));
  }

  private DeviceText(Json object) {
    this(members(object));
  }

  private static Map<String, String> members(Json value) {
    Map<String, String> members = new LinkedHashMap<>();
    if (value instanceof Json.Members object) {
      object.byKey().forEach((key, member) -> members.put(key, JsonValues.of(member.value())));
    }
    return members;
  }

  /** A device of a kind that has nothing but its name. */
  static DeviceText of(DeviceKind kind, String name) {
    DeviceText typed = new DeviceText(Map.of(TYPE, JsonValues.text(kind.type())));
    return name.equals(kind.type()) ? typed : typed.named(name);
  }

  /**
   * The devices of a scene.
   *
   * @param array JSON that a scene may have as its devices
   */
  static List<DeviceText> read(String array) {
    List<DeviceText> devices = new ArrayList<>();
    if (parsed(array) instanceof Json.Elements elements) {
      for (Json each : elements.values()) {
        devices.add(new DeviceText(each));
      }
    }
    return devices;
  }

  private static Json parsed(String json) {
    try {
      return JsonFile.read(
          "device", new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8)));
    } catch (JsonException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /** Devices as a scene has them, a line for each. */
  static String write(List<DeviceText> devices) {
    return devices.stream()
        .map(each -> "    " + each.json())
        .collect(Collectors.joining(",\n", "[\n", "\n  ]"));
  }

  private String json() {
    return members.entrySet().stream()
        .map(each -> JsonValues.text(each.getKey()) + ": " + each.getValue())
        .collect(Collectors.joining(", ", "{", "}"));
  }

  /** The word for what it is. */
  String type() {
    return text(TYPE);
  }

  /** What it is, for people. */
  String title() {
    return DeviceKind.of(type()).map(DeviceKind::title).orElse(type());
  }

  /** What it is called: its type where nothing else is said. */
  String name() {
    return members.containsKey(NAME) ? text(NAME) : type();
  }

  DeviceText named(String name) {
    return with(NAME, JsonValues.text(name));
  }

  /** Whether it says something of a key. */
  boolean has(String key) {
    return members.containsKey(key);
  }

  /** A text; empty where there is none. */
  String text(String key) {
    String json = members.get(key);
    return json != null && parsed(json) instanceof Json.Text text ? text.value() : "";
  }

  /** All texts in it. */
  List<String> texts() {
    return members.keySet().stream().map(this::text).filter(each -> !each.isEmpty()).toList();
  }

  /** With another text; empty for none. */
  DeviceText withText(String key, String text) {
    return text.isEmpty() ? without(key) : with(key, JsonValues.text(text));
  }

  /** Several texts; none where there are none. */
  List<String> list(String key) {
    String json = members.get(key);
    return json != null && parsed(json) instanceof Json.Elements elements
        ? elements.values().stream()
            .map(each -> each instanceof Json.Text text ? text.value() : "")
            .toList()
        : List.of();
  }

  /** With other texts; nothing where there are none. */
  DeviceText withList(String key, List<String> texts) {
    return texts.isEmpty()
        ? without(key)
        : with(
            key, texts.stream().map(JsonValues::text).collect(Collectors.joining(", ", "[", "]")));
  }

  /** Numbers by their names, as people type them: {@code register[3] = 17, coil[0] = 1}. */
  String values(String key) {
    String json = members.get(key);
    return json != null && parsed(json) instanceof Json.Members object
        ? object.byKey().entrySet().stream()
            .map(each -> each.getKey() + " = " + JsonValues.of(each.getValue().value()))
            .collect(Collectors.joining(", "))
        : "";
  }

  /**
   * With other numbers by their names; nothing where there are none.
   *
   * @throws IllegalArgumentException if that is not what {@link #values} makes
   */
  DeviceText withValues(String key, String typed) {
    if (typed.isBlank()) {
      return without(key);
    }
    Map<String, String> values = new LinkedHashMap<>();
    for (String each : typed.split(",", -1)) {
      Matcher parts = NAMED_NUMBER.matcher(each.strip());
      if (!parts.matches()) {
        throw new IllegalArgumentException(CellTexts.text("notNamedNumber", each.strip()));
      }
      values.put(parts.group(1), parts.group(2));
    }
    return with(
        key,
        values.entrySet().stream()
            .map(each -> JsonValues.text(each.getKey()) + ": " + each.getValue())
            .collect(Collectors.joining(", ", "{", "}")));
  }

  OptionalDouble number(String key) {
    String json = members.get(key);
    return json != null && parsed(json) instanceof Json.Numeral number
        ? OptionalDouble.of(number.value())
        : OptionalDouble.empty();
  }

  /** With another number; empty for none. */
  DeviceText withNumber(String key, OptionalDouble number) {
    return number.isPresent() ? with(key, JsonValues.number(number.getAsDouble())) : without(key);
  }

  boolean flag(String key, boolean standing) {
    return Optional.ofNullable(members.get(key)).map(Boolean::parseBoolean).orElse(standing);
  }

  /** Says nothing where nothing needs to be said. */
  DeviceText withFlag(String key, boolean on, boolean standing) {
    return on == standing ? without(key) : with(key, Boolean.toString(on));
  }

  /** A place, m. */
  Vector3 place(String key) {
    String json = members.get(key);
    if (json != null
        && parsed(json) instanceof Json.Elements elements
        && elements.values().size() == AXES) {
      return new Vector3(
          value(elements.values().get(0)),
          value(elements.values().get(1)),
          value(elements.values().get(2)));
    }
    return new Vector3(0, 0, 0);
  }

  /** A pose; empty where there is none. */
  Optional<Pose> pose(String key) {
    String json = members.get(key);
    return json != null
            && parsed(json) instanceof Json.Elements elements
            && elements.values().size() == Pose.SIZE
        ? Optional.of(Pose.of(elements.values().stream().mapToDouble(DeviceText::value).toArray()))
        : Optional.empty();
  }

  /** With another pose; empty for none. */
  DeviceText withPose(String key, Optional<Pose> pose) {
    return pose.isPresent() ? with(key, JsonValues.numbers(pose.get().toArray())) : without(key);
  }

  /** What an object in it says; nothing where there is none. */
  DeviceText inner(String key) {
    return new DeviceText(parsed(members.getOrDefault(key, "{}")));
  }

  /** With another object in it, which goes when it says nothing. */
  DeviceText withInner(String key, DeviceText inner) {
    return inner.members.isEmpty() ? without(key) : with(key, inner.json());
  }

  private static double value(Json json) {
    return json instanceof Json.Numeral number ? number.value() : 0;
  }

  DeviceText withPlace(String key, Vector3 place) {
    return with(key, JsonValues.numbers(place.x(), place.y(), place.z()));
  }

  private DeviceText with(String key, String json) {
    Map<String, String> next = new LinkedHashMap<>(members);
    next.put(key, json);
    return new DeviceText(next);
  }

  private DeviceText without(String key) {
    Map<String, String> next = new LinkedHashMap<>(members);
    next.remove(key);
    return new DeviceText(next);
  }
}
