package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.wire.CellSignalNames;
import org.pendant.models.json.FilePosition;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;

/**
 * Device reader: reads the devices of a scene; docs/devices.md describes them, {@link DeviceKind}
 * has their fields.
 */
public final class DeviceReader {
  private static final int MAX_NAME = 60;

  private final Map<String, FilePosition> places = new HashMap<>();

  private final DevicePorts ports = new DevicePorts();

  private final CameraReader cameras = new CameraReader(ports);

  private final PlcReader plcs = new PlcReader(ports);

  private final PartReader parts;

  private final CellSignalNames signals;

  private final List<String> controllers;

  private DeviceReader(PartReader parts, CellSignalNames signals, List<String> controllers) {
    this.parts = parts;
    this.signals = signals;
    this.controllers = controllers;
  }

  /**
   * Reads the section {@code devices}.
   *
   * @param signals what wires may lead to; those of the devices come to it
   * @param controllers of the cell, by their names; none where there is one alone
   * @throws JsonException for the first thing that is wrong, with its place
   */
  public static List<OwnedDevice> read(
      JsonFields scene, CellSignalNames signals, List<String> controllers) throws JsonException {
    DeviceReader reader = new DeviceReader(PartReader.of(scene), signals, controllers);
    List<Json> all = scene.array("devices", CellDevices.MAX);
    Map<Json, OwnedDevice> read = new IdentityHashMap<>();
    // wires may lead to the signals of devices that come later
    for (boolean wired : List.of(false, true)) {
      for (Json each : all) {
        DeviceKind kind = kind(each);
        if (kind.wired() == wired) {
          int owner = DeviceOwner.of(new JsonFields(each, text("aDevice")), kind, controllers);
          read.put(each, new OwnedDevice(owner, reader.device(kind, each), each.place()));
        }
      }
    }
    return all.stream().map(read::get).toList();
  }

  private static DeviceKind kind(Json device) throws JsonException {
    Json.Text type = new JsonFields(device, text("aDevice")).text("type");
    return DeviceKind.of(type.value()).orElseThrow(() -> unknown(type));
  }

  private DeviceSetup device(DeviceKind kind, Json value) throws JsonException {
    DeviceSetup device = setup(kind, value);
    if (!device.signals().isEmpty()) {
      JsonFields fields = new JsonFields(value, text("aDevice"));
      Json.Text name = fields.text(fields.optional("name").isPresent() ? "name" : "type");
      try {
        if (controllers.contains(device.name())) {
          throw name.place().refusal(text("nameOfController", name.described()));
        }
        signals.add(device.name(), device.signals());
      } catch (IllegalArgumentException e) {
        throw name.place().refusal(e.getMessage());
      }
    }
    return device;
  }

  private DeviceSetup setup(DeviceKind kind, Json value) throws JsonException {
    JsonFields all = new JsonFields(value, "a " + kind.type());
    String[] others =
        controllers.isEmpty()
            ? new String[] {"type", "name"}
            : new String[] {"type", "name", DeviceOwner.KEY};
    FieldReader fields = new FieldReader(kind.fields(), all, signals, others);
    String name = name(all);
    return switch (kind.type()) {
      case "two-finger", "two-finger-tool" ->
          new DeviceSetup.TwoFinger(
              name,
              kind.type().equals("two-finger-tool"),
              fields.flag("activated"),
              fields.number("part"),
              GripperReader.fingers(fields));
      case "rg", "2fg" ->
          new DeviceSetup.RpcGripper(
              name, kind.type(), fields.number("part"), GripperReader.fingers(fields));
      case "gripper" -> gripper(name, fields);
      case "vacuum" ->
          new DeviceSetup.Vacuum(
              name,
              fields.signal("suck"),
              fields.wire("holds"),
              fields.number("time"),
              fields.flag("part"),
              GripperReader.cup(fields));
      case "door" ->
          new DeviceSetup.Door(
              name,
              fields.signal("close"),
              fields.wire("open"),
              fields.wire("closed"),
              fields.wire("opened"),
              fields.number("time"),
              parts.leaf(fields));
      case "belt" -> parts.belt(name, fields);
      case "source" -> parts.source(name, fields);
      case "rail" -> parts.rail(name, fields);
      case "limit-switch", "button" ->
          new DeviceSetup.Switch(
              name,
              kind.type(),
              fields.signal("signal"),
              fields.area("min", "max"),
              fields.flag("inverted"));
      case "lamp" -> new DeviceSetup.Lamp(name, fields.signal("signal"), fields.spot("at"));
      case "modbus" -> plcs.modbus(name, fields);
      case "ethernetip" -> PlcReader.scanner(name, fields);
      case "camera" -> cameras.camera(name, fields, parts);
      case "sink" -> new DeviceSetup.Sink(name, fields.area("min", "max"));
      default ->
          new DeviceSetup.Sensor(
              name, fields.signal("signal"), zone(kind, fields), fields.flag("inverted"));
    };
  }

  private static DeviceSetup gripper(String name, FieldReader fields) throws JsonException {
    double strokeM = fields.number("stroke");
    return new DeviceSetup.Driven(
        name,
        fields.signal("close"),
        fields.wire("open"),
        fields.wire("closed"),
        fields.wire("opened"),
        fields.wire("gripped"),
        strokeM,
        fields.number("time"),
        fields.number("part", strokeM),
        GripperReader.fingers(fields));
  }

  private static Zone zone(DeviceKind kind, FieldReader fields) throws JsonException {
    return switch (kind.type()) {
      case "light-barrier" ->
          new Zone.Beam(fields.place("from"), fields.place("to"), fields.number("radius"));
      case "proximity" -> new Zone.Ball(fields.place("at"), fields.number("range"));
      default -> fields.area("min", "max");
    };
  }

  private static JsonException unknown(Json.Text type) {
    List<String> all = DeviceKind.ALL.stream().map(DeviceKind::type).toList();
    return type.place()
        .refusal(
            text(
                "unknownType",
                type.described(),
                String.join(", ", all.subList(0, all.size() - 1)),
                all.getLast()));
  }

  /** The name of a device: its type where it has none. */
  private String name(JsonFields fields) throws JsonException {
    Json.Text name = fields.text(fields.optional("name").isPresent() ? "name" : "type");
    if (name.value().isBlank() || name.value().length() > MAX_NAME) {
      throw name.place().refusal(text("nameLength", name.described(), MAX_NAME));
    }
    FilePosition first = places.putIfAbsent(name.value(), name.place());
    if (first != null) {
      throw name.place().refusal(text("nameTwice", name.described(), first.line()));
    }
    return name.value();
  }
}
