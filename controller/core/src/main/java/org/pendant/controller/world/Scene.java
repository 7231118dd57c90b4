package org.pendant.controller.world;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
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
 * @param pushAtTcpInBase what pushes the tool from the start: at the tool centre point, along the
 *     axes of the base
 * @param links what becomes of links of the arm that get into something
 */
public record Scene(
    List<SceneObject> objects,
    Optional<Payload> load,
    List<ToolPoint> toolPoints,
    Wrench pushAtTcpInBase,
    LinkContact links) {
  /** Objects in a scene at most; each of them is looked at for every tool point in every step. */
  public static final int MAX_OBJECTS = 1000;

  /** Tool points in a scene at most. */
  public static final int MAX_TOOL_POINTS = 16;

  /** Nothing around the arm. */
  public static final Scene EMPTY = new Scene(List.of(), Optional.empty(), List.of());

  /**
   * Checks the counts and names.
   *
   * @throws IllegalArgumentException for too many objects or tool points, for two objects with one
   *     name, and for ones with a mass that overlap others
   */
  public Scene {
    objects = List.copyOf(objects);
    toolPoints = List.copyOf(toolPoints);
    requireCount("objects", objects.size(), MAX_OBJECTS);
    requireCount("tool points", toolPoints.size(), MAX_TOOL_POINTS);
    Set<String> names = new HashSet<>();
    for (SceneObject object : objects) {
      if (!names.add(object.name())) {
        throw new IllegalArgumentException(
            "name is " + Json.quoted(object.name()) + " again, must be another for each object");
      }
    }
    if (FreeBodies.any(objects)) {
      FreeBodies.require(objects, toolPoints);
    }
  }

  /** A scene in which nothing pushes, and links stop at things. */
  public Scene(List<SceneObject> objects, Optional<Payload> load, List<ToolPoint> toolPoints) {
    this(objects, load, toolPoints, Wrench.ZERO, LinkContact.STOP);
  }

  /** The same with other objects. */
  public Scene withObjects(List<SceneObject> others) {
    return new Scene(others, load, toolPoints, pushAtTcpInBase, links);
  }

  /** The same with another load. */
  public Scene withLoad(Optional<Payload> other) {
    return new Scene(objects, other, toolPoints, pushAtTcpInBase, links);
  }

  /** The same with other tool points. */
  public Scene withToolPoints(List<ToolPoint> others) {
    return new Scene(objects, load, others, pushAtTcpInBase, links);
  }

  /** The same with another push. */
  public Scene withPush(Wrench atTcpInBase) {
    return new Scene(objects, load, toolPoints, atTcpInBase, links);
  }

  /** The same with links that stop at things or pass through them. */
  public Scene withLinks(LinkContact contact) {
    return new Scene(objects, load, toolPoints, pushAtTcpInBase, contact);
  }

  private static void requireCount(String what, int count, int most) {
    if (count > most) {
      throw new IllegalArgumentException(
          "scene has " + count + " " + what + ", must be at most " + most);
    }
  }
}
