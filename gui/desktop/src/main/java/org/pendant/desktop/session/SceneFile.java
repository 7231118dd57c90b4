package org.pendant.desktop.session;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.box.EquipmentPlan;
import org.pendant.controller.layout.CellLayout;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneWriter;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonMembers;
import org.pendant.models.json.JsonValues;

/**
 * Scene file: what stands around the arm, and where that was read.
 *
 * @param name for people; empty for no scene
 * @param onDisk the file; empty for a text that has none
 * @param text the file's text
 * @param plan what it says
 */
public record SceneFile(String name, Optional<SavedProgram> onDisk, String text, CellPlan plan) {
  /** How names of scenes end. */
  public static final String ENDING = ".scene.json";

  private static final String DEVICES = "devices";

  /** Empty space. */
  public static final SceneFile NONE =
      new SceneFile(
          "",
          Optional.empty(),
          "{}\n",
          new CellPlan("", Scene.EMPTY, CellLayout.ALONE, EquipmentPlan.NONE));

  /** Whether a file is called as scenes are. */
  public static boolean hasEnding(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(ENDING);
  }

  /**
   * Reads a file; not for the dispatch thread.
   *
   * @throws IOException if it cannot be read or is no scene; its message is the file, the place in
   *     it and the reason
   */
  public static SceneFile read(Path file) throws IOException {
    Path whole = file.toAbsolutePath().normalize();
    SavedProgram read = SavedProgram.read(whole);
    return new SceneFile(
        String.valueOf(whole.getFileName()),
        Optional.of(read),
        read.text(),
        plan(whole.toString(), read.text(), MeshFiles.in(whole.getParent())));
  }

  /**
   * A text that has no file, and names none.
   *
   * @throws IOException if it is no scene; its message has the place and the reason
   */
  public static SceneFile of(String name, String text) throws IOException {
    return of(name, text, MeshFiles.NONE);
  }

  /**
   * A text that has no file.
   *
   * @param meshes the files that it may name
   * @throws IOException if it is no scene; its message has the place and the reason
   */
  public static SceneFile of(String name, String text, MeshFiles meshes) throws IOException {
    return new SceneFile(name, Optional.empty(), text, plan(name, text, meshes));
  }

  /**
   * The same with more devices, which are not on disk.
   *
   * @param kinds of devices that need nothing but their name
   * @throws IOException if a scene cannot have them
   */
  public SceneFile with(List<String> kinds) throws IOException {
    Map<String, String> members = new LinkedHashMap<>(JsonMembers.of(text));
    members.keySet().removeAll(SceneWriter.KEYS);
    String array = members.getOrDefault(DEVICES, "[]").strip();
    String there = array.substring(1, array.length() - 1).strip();
    Stream<String> more = kinds.stream().map(kind -> "{\"type\": " + JsonValues.text(kind) + "}");
    members.put(
        DEVICES,
        Stream.concat(there.isEmpty() ? Stream.of() : Stream.of(there), more)
            .collect(Collectors.joining(",\n    ", "[\n    ", "\n  ]")));
    String known = isNone() ? SceneDraft.UNTITLED : name;
    String next = SceneWriter.write(scene(), members);
    return new SceneFile(
        known, onDisk, next, plan(known, next, MeshFiles.of(scene(), plan.meshesOfArms())));
  }

  /** The same, known by another file. */
  public SceneFile at(String newName, Optional<SavedProgram> file) {
    return new SceneFile(newName, file, text, plan);
  }

  private static CellPlan plan(String name, String text, MeshFiles meshes) throws IOException {
    try {
      return CellPlan.read(name, bytes(text), meshes);
    } catch (JsonException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  private static ByteArrayInputStream bytes(String text) {
    return new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8));
  }

  /** What it says of objects and load, in the frame of the cell. */
  public Scene scene() {
    return plan.scene();
  }

  /** What it says of devices and rules of the first controller. */
  public CellEquipment equipment() {
    return plan.equipment().ofFirst();
  }

  /** Whether there is one controller alone. */
  public boolean alone() {
    return plan.layout().alone();
  }

  /** A controller that is alone with all of it. */
  public ControllerOptions in(ControllerOptions options) {
    return options.withScene(scene()).withEquipment(equipment());
  }

  /** Where it is on disk. */
  public Optional<Path> path() {
    return onDisk.map(SavedProgram::path);
  }

  /** Whether there is no scene. */
  public boolean isNone() {
    return name.isEmpty();
  }

  /** What is in it, in words. */
  public String words() {
    int devices = plan.equipment().devices().stream().mapToInt(each -> each.devices().size()).sum();
    List<String> controllers = plan.layout().names();
    int objects = scene().objects().size();
    String words = SessionTexts.text(objects == 1 ? "sceneOfOne" : "sceneOf", name, objects);
    if (devices > 0) {
      words = SessionTexts.text(devices == 1 ? "andOneDevice" : "andDevices", words, devices);
    }
    if (scene().load().isPresent()) {
      words = SessionTexts.text("andALoad", words);
    }
    return controllers.isEmpty()
        ? words
        : SessionTexts.text("andControllers", words, String.join(", ", controllers));
  }
}
