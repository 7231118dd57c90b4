package org.pendant.project.program.text;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.WaypointPosition;

/**
 * Clipboard text: nodes on their way from one program to another.
 *
 * @param nodes in order
 * @param waypoints the places that they refer to, by name
 */
public record Clip(List<ProgramNode> nodes, Map<String, WaypointPosition> waypoints) {
  public Clip {
    nodes = List.copyOf(nodes);
    waypoints = Collections.unmodifiableMap(new LinkedHashMap<>(waypoints));
  }
}
