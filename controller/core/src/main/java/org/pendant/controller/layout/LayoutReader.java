package org.pendant.controller.layout;

import static org.pendant.controller.layout.LayoutTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.pendant.controller.wire.CellSignal;
import org.pendant.controller.wire.CellSignalNames;
import org.pendant.controller.world.LoadReader;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.SceneTool;
import org.pendant.controller.world.ToolReader;
import org.pendant.language.check.Nearest;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.json.FilePosition;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/** Layout reader: reads arms, script and wires of a cell; docs/cells.md describes them. */
public final class LayoutReader {
  /** Wires of a cell at most. */
  public static final int MAX_WIRES = 256;

  private static final int MAX_FILE_NAME = 200;
  private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9_]{0,29}");
  private static final Pattern LOOPBACK =
      Pattern.compile("127(\\.(25[0-5]|2[0-4]\\d|1?\\d?\\d)){3}");
  private static final Range POSITION = new Range(-10, 10, "m");
  private static final Range ROTATION = new Range(-100, 100, "rad");
  private static final Range JOINT = new Range(-2 * Math.PI, 2 * Math.PI, "rad");

  private final Map<String, FilePosition> names = new HashMap<>();
  private final Map<String, FilePosition> addresses = new HashMap<>();

  /** The files that tools may name; empty for tools that are not looked at. */
  private final Optional<MeshFiles> meshes;

  private LayoutReader(Optional<MeshFiles> meshes) {
    this.meshes = meshes;
  }

  /**
   * Reads the sections {@code arms} and {@code script} of a scene.
   *
   * @param meshes the files that tools of arms may name
   * @throws JsonException for the first thing that is wrong, with its place
   */
  public static CellLayout read(JsonFields scene, MeshFiles meshes) throws JsonException {
    return new LayoutReader(Optional.of(meshes)).layout(scene);
  }

  /**
   * As {@link #read}, without the tools of arms, which are not looked at.
   *
   * @throws JsonException for the first thing that is wrong, with its place
   */
  public static CellLayout readWithoutTools(JsonFields scene) throws JsonException {
    return new LayoutReader(Optional.empty()).layout(scene);
  }

  private CellLayout layout(JsonFields scene) throws JsonException {
    List<ArmEntry> arms = new ArrayList<>();
    for (Json each : scene.array("arms", CellLayout.MAX_ARMS)) {
      arms.add(arm(new JsonFields(each, text("arm"))));
    }
    return new CellLayout(arms, file(scene, "script"));
  }

  private ArmEntry arm(JsonFields fields) throws JsonException {
    fields.allow(
        Nearest::among,
        "name",
        "robot",
        "base",
        "start",
        "program",
        "installation",
        "address",
        "load",
        "tool");
    Optional<Json> load = fields.optional("load");
    Optional<Payload> payload =
        load.isPresent() ? Optional.of(LoadReader.load(load.get())) : Optional.empty();
    Optional<SceneTool> tool =
        meshes.isPresent() && fields.optional("tool").isPresent()
            ? Optional.of(ToolReader.read(fields, meshes.get()))
            : Optional.empty();
    return new ArmEntry(
        name(fields),
        robot(fields),
        base(fields),
        start(fields),
        file(fields, "program"),
        file(fields, "installation"),
        address(fields),
        payload,
        tool,
        fields.place());
  }

  private String name(JsonFields fields) throws JsonException {
    Json.Text name = fields.text("name");
    if (!NAME.matcher(name.value()).matches() || name.value().equals(CellLayout.SCRIPT_OWNER)) {
      throw name.place().refusal(text("name", name.described()));
    }
    once(names, name, "name");
    return name.value();
  }

  private static void once(Map<String, FilePosition> there, Json.Text text, String key)
      throws JsonException {
    FilePosition first = there.putIfAbsent(text.value(), text.place());
    if (first != null) {
      throw text.place().refusal(text("again", key, text.described(), first.line()));
    }
  }

  private static Optional<String> robot(JsonFields fields) throws JsonException {
    if (fields.optional("robot").isEmpty()) {
      return Optional.empty();
    }
    Json.Text robot = fields.text("robot");
    if (!ArmLibrary.ids().contains(robot.value())) {
      throw robot
          .place()
          .refusal(text("robot", robot.described(), String.join(", ", ArmLibrary.ids())));
    }
    return Optional.of(robot.value());
  }

  private static Pose base(JsonFields fields) throws JsonException {
    if (fields.optional("base").isEmpty()) {
      return Pose.ZERO;
    }
    List<Json> six = fields.numbers("base", Pose.SIZE);
    double[] pose = new double[Pose.SIZE];
    for (int i = 0; i < pose.length; i++) {
      pose[i] = JsonFields.number("base[" + i + "]", six.get(i), i < 3 ? POSITION : ROTATION);
    }
    return Pose.of(pose);
  }

  private static Optional<Joints> start(JsonFields fields) throws JsonException {
    if (fields.optional("start").isEmpty()) {
      return Optional.empty();
    }
    List<Json> six = fields.numbers("start", Joints.COUNT);
    double[] q = new double[Joints.COUNT];
    for (int i = 0; i < q.length; i++) {
      q[i] = JsonFields.number("start[" + i + "]", six.get(i), JOINT);
    }
    return Optional.of(new Joints(q[0], q[1], q[2], q[3], q[4], q[5]));
  }

  private Optional<String> address(JsonFields fields) throws JsonException {
    if (fields.optional("address").isEmpty()) {
      return Optional.empty();
    }
    Json.Text address = fields.text("address");
    if (!LOOPBACK.matcher(address.value()).matches()) {
      throw address.place().refusal(text("address", address.described()));
    }
    once(addresses, address, "address");
    return Optional.of(address.value());
  }

  private static Optional<NamedFile> file(JsonFields fields, String key) throws JsonException {
    if (fields.optional(key).isEmpty()) {
      return Optional.empty();
    }
    Json.Text name = fields.text(key);
    String text = name.value();
    if (text.isBlank()
        || text.length() > MAX_FILE_NAME
        || text.startsWith("/")
        || text.contains("\\")
        || text.contains(":")
        || List.of(text.split("/", -1)).contains("..")) {
      throw name.place().refusal(text("file", key, name.described()));
    }
    return Optional.of(new NamedFile(text, name.place()));
  }

  /**
   * Reads the section {@code wires} of a scene.
   *
   * @param signals what they may join
   * @throws JsonException for the first thing that is wrong, with its place
   */
  public static List<SignalWire> wires(JsonFields scene, CellLayout layout, CellSignalNames signals)
      throws JsonException {
    List<SignalWire> wires = new ArrayList<>();
    Map<CellSignal, FilePosition> driven = new HashMap<>();
    for (Json each : scene.array("wires", MAX_WIRES)) {
      if (!(each instanceof Json.Elements ends)
          || ends.values().size() != 2
          || !(ends.values().get(0) instanceof Json.Text from)
          || !(ends.values().get(1) instanceof Json.Text to)) {
        throw JsonFields.wrong(text("wire"), each, text("twoSignals"));
      }
      SignalWire wire =
          new SignalWire(signals.digital(from, "wire", false), signals.digital(to, "wire", true));
      FilePosition first = driven.putIfAbsent(withOwner(wire.to(), layout), to.place());
      if (first != null) {
        throw to.place().refusal(text("wireAgain", to.described(), first.line()));
      }
      wires.add(wire);
    }
    return wires;
  }

  /** Two names of one signal are one. */
  private static CellSignal withOwner(CellSignal signal, CellLayout layout) {
    return signal.owner().isEmpty() && !layout.alone()
        ? new CellSignal(layout.names().getFirst(), signal.group(), signal.index())
        : signal;
  }
}
