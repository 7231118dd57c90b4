package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.json.Json;
import org.pendant.models.pose.Wrench;

/**
 * Scene: what is around the arm; {@link SceneReader} reads it from a file.
 *
 * @param objects what the tool can touch, at most {@value #MAX_OBJECTS}, each with its own name
 * @param load what truly hangs on the flange, whatever a program declares; empty when nothing is
 *     known beyond that
 * @param toolPoints where the tool touches things, at most {@value #MAX_TOOL_POINTS}; empty for the
 *     active tool centre point alone
 * @param toolBodies solids on the flange, at most {@value #MAX_TOOL_BODIES}, each with its own
 *     name; what they call their pose in the base is one in the flange's frame
 * @param pushAtTcpInBase what pushes the tool from the start: at the tool centre point, along the
 *     axes of the base
 * @param links what becomes of links of the arm that get into something
 */
public record Scene(
    List<SceneObject> objects,
    Optional<Payload> load,
    List<ToolPoint> toolPoints,
    List<SceneObject> toolBodies,
    Wrench pushAtTcpInBase,
    LinkContact links) {
  /** Objects in a scene at most; each of them is looked at for every tool point in every step. */
  public static final int MAX_OBJECTS = 1000;

  /** Tool points in a scene at most. */
  public static final int MAX_TOOL_POINTS = 16;

  /** Solids on the flange at most. */
  public static final int MAX_TOOL_BODIES = 16;

  /** Nothing around the arm. */
  public static final Scene EMPTY = new Scene(List.of(), Optional.empty(), List.of());

  /**
   * Checks the counts and names.
   *
   * @throws IllegalArgumentException for too many objects or parts of the tool, for two with one
   *     name, for objects with a mass that overlap others, and for a load besides solids on the
   *     flange that have a mass
   */
  public Scene {
    objects = List.copyOf(objects);
    toolPoints = List.copyOf(toolPoints);
    toolBodies = List.copyOf(toolBodies);
    requireCount("tooManyObjects", objects.size(), MAX_OBJECTS);
    requireCount("tooManyToolPoints", toolPoints.size(), MAX_TOOL_POINTS);
    requireCount("tooManyToolBodies", toolBodies.size(), MAX_TOOL_BODIES);
    requireNames(objects, "objectTwice");
    requireNames(toolBodies, "toolBodyTwice");
    if (load.isPresent() && ToolBody.weight(toolBodies).isPresent()) {
      throw new IllegalArgumentException(text("loadAndToolMass"));
    }
    if (FreeBodies.any(objects)) {
      FreeBodies.require(objects, new SceneTool(toolPoints, toolBodies));
    }
  }

  /** A scene in which nothing pushes, and links stop at things. */
  public Scene(List<SceneObject> objects, Optional<Payload> load, List<ToolPoint> toolPoints) {
    this(objects, load, toolPoints, List.of(), Wrench.ZERO, LinkContact.STOP);
  }

  /** A scene in which the tool has no solids. */
  public Scene(
      List<SceneObject> objects,
      Optional<Payload> load,
      List<ToolPoint> toolPoints,
      Wrench pushAtTcpInBase,
      LinkContact links) {
    this(objects, load, toolPoints, List.of(), pushAtTcpInBase, links);
  }

  /** All meshes that it names, also those of parts of objects and of the tool. */
  public List<MeshPart> meshes() {
    return MeshPart.of(Stream.concat(objects.stream(), toolBodies.stream()));
  }

  /** What is on the flange. */
  public SceneTool tool() {
    return new SceneTool(toolPoints, toolBodies);
  }

  /** What truly hangs on the flange: the load, or what solids of the tool weigh; else unknown. */
  public Optional<Payload> mounted() {
    return load.isPresent() ? load : ToolBody.weight(toolBodies);
  }

  /** The same with other objects. */
  public Scene withObjects(List<SceneObject> others) {
    return new Scene(others, load, toolPoints, toolBodies, pushAtTcpInBase, links);
  }

  /** The same with another load. */
  public Scene withLoad(Optional<Payload> other) {
    return new Scene(objects, other, toolPoints, toolBodies, pushAtTcpInBase, links);
  }

  /** The same with other tool points. */
  public Scene withToolPoints(List<ToolPoint> others) {
    return new Scene(objects, load, others, toolBodies, pushAtTcpInBase, links);
  }

  /** The same with other solids on the flange. */
  public Scene withToolBodies(List<SceneObject> others) {
    return new Scene(objects, load, toolPoints, others, pushAtTcpInBase, links);
  }

  /** The same with another push. */
  public Scene withPush(Wrench atTcpInBase) {
    return new Scene(objects, load, toolPoints, toolBodies, atTcpInBase, links);
  }

  /** The same with links that stop at things or pass through them. */
  public Scene withLinks(LinkContact contact) {
    return new Scene(objects, load, toolPoints, toolBodies, pushAtTcpInBase, contact);
  }

  private static void requireNames(List<SceneObject> all, String refusalKey) {
    Set<String> names = new HashSet<>();
    for (SceneObject each : all) {
      if (!names.add(each.name())) {
        throw new IllegalArgumentException(text(refusalKey, Json.quoted(each.name())));
      }
    }
  }

  private static void requireCount(String refusalKey, int count, int most) {
    if (count > most) {
      throw new IllegalArgumentException(text(refusalKey, count, most));
    }
  }
}
