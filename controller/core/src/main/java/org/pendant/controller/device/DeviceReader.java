package org.pendant.controller.device;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalFields;
import org.pendant.language.check.Nearest;
import org.pendant.models.json.FilePosition;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/** Device reader: reads the devices of a scene; docs/devices.md describes them. */
public final class DeviceReader {
  private static final int MAX_NAME = 60;
  private static final Range STROKE = new Range(0.001, 1, "m");
  private static final Range TIME = new Range(0.01, 60, "s");

  private final Map<String, FilePosition> places = new HashMap<>();

  private final PartReader parts;

  private DeviceReader(PartReader parts) {
    this.parts = parts;
  }

  /**
   * Reads the section {@code devices}.
   *
   * @throws JsonException for the first thing that is wrong, with its place
   */
  public static List<DeviceSetup> read(JsonFields scene) throws JsonException {
    DeviceReader reader = new DeviceReader(PartReader.of(scene));
    List<DeviceSetup> devices = new ArrayList<>();
    for (Json each : scene.array("devices", CellDevices.MAX)) {
      devices.add(reader.device(each));
    }
    return devices;
  }

  private DeviceSetup device(Json value) throws JsonException {
    Json.Text type = new JsonFields(value, "a device").text("type");
    JsonFields fields = new JsonFields(value, "a " + type.value());
    return switch (type.value()) {
      case "two-finger", "two-finger-tool" -> twoFinger(fields);
      case "rg", "2fg" -> procedures(fields);
      case "gripper" -> gripper(fields);
      case "door" -> door(fields);
      case "vacuum" -> vacuum(fields);
      case "light-barrier", "proximity", "area" -> sensor(fields, type.value());
      case "belt" -> parts.belt(name(fields), fields);
      case "source" -> parts.source(name(fields), fields);
      case "sink" -> parts.sink(name(fields), fields);
      default ->
          throw type.place()
              .refusal(
                  "type is "
                      + type.described()
                      + ", must be "
                      + String.join(", ", DeviceSetup.KINDS)
                      + ", gripper, vacuum, door, light-barrier, proximity, area, belt, source or"
                      + " sink");
    };
  }

  private DeviceSetup twoFinger(JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "activated", "part", "fingers");
    boolean atTool = fields.text("type").value().equals("two-finger-tool");
    DeviceSetup.TwoFinger plain = new DeviceSetup.TwoFinger(name(fields), atTool, !atTool, 0);
    return new DeviceSetup.TwoFinger(
        plain.name(),
        atTool,
        fields.optional("activated").isEmpty() ? plain.activated() : fields.flag("activated"),
        fields.number("part", new Range(0, plain.strokeM(), "m"), 0),
        HandReader.fingers(fields));
  }

  private DeviceSetup procedures(JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "part", "fingers");
    String kind = fields.text("type").value();
    DeviceSetup.RpcGripper plain = new DeviceSetup.RpcGripper(name(fields), kind, 0);
    return new DeviceSetup.RpcGripper(
        plain.name(),
        kind,
        fields.number("part", new Range(0, plain.strokeM(), "m"), 0),
        HandReader.fingers(fields));
  }

  private DeviceSetup gripper(JsonFields fields) throws JsonException {
    fields.allow(
        Nearest::among,
        "type",
        "name",
        "close",
        "open",
        "closed",
        "opened",
        "gripped",
        "stroke",
        "time",
        "part",
        "fingers");
    double strokeM = fields.number("stroke", STROKE, 0.05);
    return new DeviceSetup.Driven(
        name(fields),
        "gripper",
        SignalFields.signal(fields, "close"),
        signal(fields, "open"),
        input(fields, "closed"),
        input(fields, "opened"),
        input(fields, "gripped"),
        strokeM,
        fields.number("time", TIME, 0.2),
        fields.number("part", new Range(0, strokeM, "m"), 0),
        HandReader.fingers(fields));
  }

  private DeviceSetup door(JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "close", "open", "closed", "opened", "time");
    return new DeviceSetup.Driven(
        name(fields),
        "door",
        SignalFields.signal(fields, "close"),
        signal(fields, "open"),
        input(fields, "closed"),
        input(fields, "opened"),
        Optional.empty(),
        1,
        fields.number("time", TIME, 2),
        0,
        Optional.empty());
  }

  private DeviceSetup vacuum(JsonFields fields) throws JsonException {
    fields.allow(Nearest::among, "type", "name", "suck", "holds", "time", "part", "cup");
    return new DeviceSetup.Vacuum(
        name(fields),
        SignalFields.signal(fields, "suck"),
        input(fields, "holds"),
        fields.number("time", TIME, 0.15),
        fields.flag("part"),
        HandReader.cup(fields));
  }

  private DeviceSetup sensor(JsonFields fields, String type) throws JsonException {
    ZoneReader.allow(fields, type);
    return new DeviceSetup.Sensor(
        name(fields),
        SignalFields.input(fields, "signal"),
        ZoneReader.zone(fields, type),
        fields.flag("inverted"));
  }

  private static Optional<Signal> signal(JsonFields fields, String key) throws JsonException {
    return fields.optional(key).isPresent()
        ? Optional.of(SignalFields.signal(fields, key))
        : Optional.empty();
  }

  private static Optional<Signal> input(JsonFields fields, String key) throws JsonException {
    return fields.optional(key).isPresent()
        ? Optional.of(SignalFields.input(fields, key))
        : Optional.empty();
  }

  /** The name of a device: its type where it has none. */
  private String name(JsonFields fields) throws JsonException {
    Json.Text name = fields.text(fields.optional("name").isPresent() ? "name" : "type");
    if (name.value().isBlank() || name.value().length() > MAX_NAME) {
      throw name.place()
          .refusal("name is " + name.described() + ", must have 1 to " + MAX_NAME + " letters");
    }
    FilePosition first = places.putIfAbsent(name.value(), name.place());
    if (first != null) {
      throw name.place()
          .refusal(
              "name is "
                  + name.described()
                  + " as in line "
                  + first.line()
                  + ", must be another for each device");
    }
    return name.value();
  }
}
