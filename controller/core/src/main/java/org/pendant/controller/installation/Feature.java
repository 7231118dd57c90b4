package org.pendant.controller.installation;

import java.util.List;
import org.pendant.models.pose.Pose;

/**
 * Feature: a frame that programs refer to by name, besides base and tool.
 *
 * @param name its own among all features; a name of the language
 * @param kind what was taught
 * @param points poses of the TCP in the base frame as taught: one for a point, two for a line from
 *     the first to the second, three for a plane: origin, a point on the x axis, a point on the
 *     side of positive y; fewer while it is not finished
 * @param variable whether programs may move it: they get a variable of its name
 * @param joggable whether it can be chosen on the Move screen
 */
public record Feature(
    String name, FeatureKind kind, List<Pose> points, boolean variable, boolean joggable) {
  public Feature {
    points = List.copyOf(points);
  }
}
