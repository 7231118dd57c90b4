package org.pendant.controller.world;

import java.util.List;

/**
 * Tool of a scene: what is on the flange.
 *
 * @param points where it touches things; empty for the active tool centre point alone
 * @param bodies its solids; what they call their pose in the base is one in the flange's frame
 */
public record SceneTool(List<ToolPoint> points, List<SceneObject> bodies) {
  /** Copies the lists. */
  public SceneTool {
    points = List.copyOf(points);
    bodies = List.copyOf(bodies);
  }
}
