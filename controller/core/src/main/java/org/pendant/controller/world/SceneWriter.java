package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.json.JsonValues;
import org.pendant.models.mesh.MeshFile;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/**
 * Scene writer: writes a scene as a file that {@link SceneReader} reads, a line for each object.
 * What a file may leave out is left out.
 */
public final class SceneWriter {
  /** The keys of what a scene is made of. */
  public static final Set<String> KEYS = Set.of("objects", "load", "tool", "push", "links");

  private SceneWriter() {}

  /** The file; lines end with a line feed. */
  public static String write(Scene scene) {
    return write(scene, Map.of());
  }

  /**
   * The file, with members that a scene knows nothing of.
   *
   * @param others by key, as JSON
   */
  public static String write(Scene scene, Map<String, String> others) {
    List<String> parts = new ArrayList<>();
    if (!scene.objects().isEmpty()) {
      parts.add(list("objects", scene.objects().stream().map(SceneWriter::object).toList()));
    }
    scene.load().ifPresent(load -> parts.add("  \"load\": " + load(load)));
    List<String> tool =
        Stream.concat(
                scene.toolPoints().stream().map(SceneWriter::toolPoint),
                scene.toolBodies().stream().map(SceneWriter::object))
            .toList();
    if (!tool.isEmpty()) {
      parts.add(list("tool", tool));
    }
    if (!scene.pushAtTcpInBase().equals(Wrench.ZERO)) {
      parts.add("  \"push\": " + push(scene.pushAtTcpInBase()));
    }
    if (scene.links() != LinkContact.STOP) {
      parts.add("  \"links\": " + JsonValues.text(scene.links().word()));
    }
    others.forEach((key, json) -> parts.add("  " + JsonValues.text(key) + ": " + json));
    return parts.isEmpty() ? "{}\n" : "{\n" + String.join(",\n", parts) + "\n}\n";
  }

  private static String list(String key, List<String> entries) {
    return entries.stream()
        .map(each -> "    " + each)
        .collect(Collectors.joining(",\n", "  \"" + key + "\": [\n", "\n  ]"));
  }

  private static String parts(SceneObject.Compound compound) {
    List<String> parts = new ArrayList<>();
    for (SceneObject part : compound.parts()) {
      boolean named = !part.name().equals(CompoundReader.name(parts.size() + 1));
      parts.add(object(part, named));
    }
    return String.join(", ", parts);
  }

  private static String mass(double massKg) {
    return massKg > 0 ? ", \"mass\": " + JsonValues.number(massKg) : "";
  }

  private static String object(SceneObject object) {
    return object(object, true);
  }

  private static String object(SceneObject object, boolean named) {
    String name = named ? "\"name\": " + JsonValues.text(object.name()) + ", " : "";
    return switch (object) {
          case SceneObject.Plane plane ->
              "{\"type\": \"plane\", "
                  + name
                  + "\"point\": "
                  + vector(plane.pointInBaseM())
                  + ", \"normal\": "
                  + vector(plane.normalInBase());
          case SceneObject.Box box ->
              "{\"type\": \"box\", "
                  + name
                  + "\"pose\": "
                  + pose(box.poseInBase())
                  + ", \"size\": "
                  + vector(box.sizeM());
          case SceneObject.Rod rod ->
              "{\"type\": \""
                  + rod.type()
                  + "\", "
                  + name
                  + "\"pose\": "
                  + pose(rod.poseInBase())
                  + ", \"radius\": "
                  + JsonValues.number(rod.radiusM())
                  + ", \"length\": "
                  + JsonValues.number(rod.lengthM());
          case SceneObject.Mesh mesh ->
              "{\"type\": \"mesh\", "
                  + name
                  + "\"pose\": "
                  + pose(mesh.poseInBase())
                  + ", \"mesh\": "
                  + JsonValues.text(mesh.part().file())
                  + unit(mesh.part());
          case SceneObject.Sphere sphere ->
              "{\"type\": \"sphere\", "
                  + name
                  + "\"centre\": "
                  + vector(sphere.centreInBaseM())
                  + ", \"radius\": "
                  + JsonValues.number(sphere.radiusM());
          case SceneObject.Compound compound ->
              "{\"type\": \"compound\", "
                  + name
                  + "\"pose\": "
                  + pose(compound.poseInBase())
                  + ", \"parts\": ["
                  + parts(compound)
                  + "]";
        }
        + mass(object instanceof SceneObject.Compound all ? all.wholeKg() : object.massKg())
        + material(object.material())
        + "}";
  }

  private static String unit(MeshPart part) {
    return MeshFile.unit(part.file()).equals(Optional.of(part.unit()))
        ? ""
        : ", \"unit\": " + JsonValues.text(part.unit().word());
  }

  private static String material(Material material) {
    if (material.equals(Material.DEFAULT)) {
      return "";
    }
    return ", \"material\": {\"stiffness\": "
        + JsonValues.number(material.stiffnessNPerM())
        + ", \"damping\": "
        + JsonValues.number(material.dampingSPerM())
        + ", \"friction\": "
        + JsonValues.number(material.friction())
        + (material.restitution() > 0
            ? ", \"restitution\": " + JsonValues.number(material.restitution())
            : "")
        + "}";
  }

  private static String load(Payload load) {
    return "{\"mass\": "
        + JsonValues.number(load.massKg())
        + ", \"cog\": "
        + JsonValues.numbers(load.cogXM(), load.cogYM(), load.cogZM())
        + ", \"inertia\": "
        + JsonValues.numbers(load.ixx(), load.iyy(), load.izz(), load.ixy(), load.ixz(), load.iyz())
        + "}";
  }

  private static String toolPoint(ToolPoint point) {
    String radius =
        point.radiusM() == 0 ? "" : ", \"radius\": " + JsonValues.number(point.radiusM());
    return "{\"point\": " + vector(point.pointInFlangeM()) + radius + "}";
  }

  private static String push(Wrench push) {
    return "{\"force\": "
        + JsonValues.numbers(push.fx(), push.fy(), push.fz())
        + ", \"torque\": "
        + JsonValues.numbers(push.mx(), push.my(), push.mz())
        + "}";
  }

  private static String vector(Vector3 vector) {
    return JsonValues.numbers(vector.x(), vector.y(), vector.z());
  }

  private static String pose(Pose pose) {
    return JsonValues.numbers(pose.x(), pose.y(), pose.z(), pose.rx(), pose.ry(), pose.rz());
  }
}
