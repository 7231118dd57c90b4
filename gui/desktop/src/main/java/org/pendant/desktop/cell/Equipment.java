package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.SceneWriter;
import org.pendant.kit.text.Messages;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFile;
import org.pendant.models.json.JsonValues;

/** Equipment: the devices and rules of a scene, as members of its file, and what is wrong. */
final class Equipment {
  static final String DEVICES = "devices";
  static final String RULES = "rules";

  private static final String FILE = "text";
  private static final String NOTHING = "[]";
  private static final Pattern PLACED = Pattern.compile(FILE + ":(\\d+):(\\d+): (.*)");

  /** Lines of the whole above those of the rules. */
  private static final int ABOVE = 1;

  /** Names of objects in a device that has several. */
  private static final String OBJECTS = "objects";

  private Equipment() {}

  /** The devices among the members. */
  static List<DeviceText> devices(Map<String, String> members) {
    return DeviceText.read(members.getOrDefault(DEVICES, NOTHING));
  }

  /** The rules among the members, as JSON; empty for none. */
  static String rules(Map<String, String> members) {
    // in the file they are indented as a member is
    return members.getOrDefault(RULES, "").replace("\n  ", "\n");
  }

  /** The members with other devices. Rules that name one that is called otherwise now follow it. */
  static Map<String, String> with(Map<String, String> members, List<DeviceText> devices) {
    Map<String, String> next = new LinkedHashMap<>();
    if (!devices.isEmpty()) {
      next.put(DEVICES, DeviceText.write(devices));
    }
    next.putAll(without(members, DEVICES));
    List<String> before = devices(members).stream().map(DeviceText::name).toList();
    List<String> after = devices.stream().map(DeviceText::name).toList();
    for (String names : List.of("part", "press")) {
      next.computeIfPresent(RULES, (key, rules) -> renamed(rules, names, before, after));
    }
    return next;
  }

  /** The members with devices that follow the objects that are called otherwise now. */
  static Map<String, String> following(
      Map<String, String> members, List<SceneObject> before, List<SceneObject> after) {
    Map<String, String> next = new LinkedHashMap<>(members);
    List<String> names = before.stream().map(SceneObject::name).toList();
    List<String> now = after.stream().map(SceneObject::name).toList();
    next.computeIfPresent(
        DEVICES,
        (key, devices) -> listsRenamed(renamed(devices, "object", names, now), names, now));
    return next;
  }

  /** Devices whose lists of objects follow those that are called otherwise now. */
  private static String listsRenamed(String json, List<String> before, List<String> after) {
    List<DeviceText> devices = DeviceText.read(json);
    List<DeviceText> next =
        devices.stream()
            .map(
                each ->
                    each.withList(
                        OBJECTS,
                        each.list(OBJECTS).stream()
                            .map(name -> nameNow(name, before, after))
                            .toList()))
            .toList();
    return next.equals(devices) ? json : DeviceText.write(next);
  }

  private static String nameNow(String name, List<String> before, List<String> after) {
    int index = before.indexOf(name);
    return index >= 0 && before.size() == after.size() && !after.contains(name)
        ? after.get(index)
        : name;
  }

  /** A text in which what one of some names is said of is said of its name afterwards. */
  private static String renamed(String json, String key, List<String> before, List<String> after) {
    String next = json;
    for (int i = 0; before.size() == after.size() && i < before.size(); i++) {
      if (!after.contains(before.get(i))) {
        next =
            Pattern.compile(
                    "(\"" + key + "\"\\s*:\\s*)" + Pattern.quote(JsonValues.text(before.get(i))))
                .matcher(next)
                .replaceAll("$1" + Matcher.quoteReplacement(JsonValues.text(after.get(i))));
      }
    }
    return next;
  }

  /** The members with other rules, JSON or nothing. */
  static Map<String, String> with(Map<String, String> members, String rules) {
    Map<String, String> next = without(members, RULES);
    if (!rules.isBlank() && !rules.replaceAll("\\s", "").equals(NOTHING)) {
      next.put(RULES, rules.strip().replace("\n", "\n  "));
    }
    return next;
  }

  private static Map<String, String> without(Map<String, String> members, String key) {
    Map<String, String> next = new LinkedHashMap<>(members);
    next.remove(key);
    return next;
  }

  /** Why a scene cannot have such members; empty if it can. */
  static String refusal(Scene scene, Map<String, String> members) {
    try {
      var _ = EquipmentReader.read(FILE, bytes(SceneWriter.write(scene, members)));
      return "";
    } catch (JsonException e) {
      return Messages.shown(PLACED.matcher(e.getMessage()).replaceFirst("$3"));
    }
  }

  /**
   * Why there cannot be such rules in place of those among the members, with its place; empty if
   * there can.
   */
  static String rulesRefusal(Scene scene, Map<String, String> members, String rules) {
    if (rules.isBlank()) {
      return "";
    }
    try {
      // alone first: what is wrong with brackets is told as that
      var _ = JsonFile.read(FILE, bytes(rules));
    } catch (JsonException e) {
      return placed(e.getMessage(), 0);
    }
    // all else in one line above them
    String others = SceneWriter.write(scene, without(members, RULES)).strip().replace("\n", "");
    String above = others.substring(0, others.length() - 1);
    try {
      var _ =
          EquipmentReader.read(
              FILE, bytes(above + (above.equals("{") ? "" : ",") + "\"rules\":\n" + rules + "\n}"));
      return "";
    } catch (JsonException e) {
      return placed(e.getMessage(), ABOVE);
    }
  }

  private static String placed(String message, int above) {
    Matcher parts = PLACED.matcher(message);
    return parts.matches()
        ? text("placedProblem")
            .formatted(
                Integer.parseInt(parts.group(1)) - above,
                parts.group(2),
                Messages.shown(parts.group(3)))
        : Messages.shown(message);
  }

  private static ByteArrayInputStream bytes(String text) {
    return new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8));
  }
}
