package org.pendant.desktop.program.form;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.TreeNames;

/** Waypoint names: the names of the places of a program, and who uses them. */
final class WaypointNames {
  private WaypointNames() {}

  /** All names, taught ones first. */
  static List<String> of(ProgramTree tree) {
    Set<String> names = new LinkedHashSet<>(tree.waypoints().keySet());
    tree.forEach(node -> names.addAll(TreeNames.waypoints(node.step())));
    names.remove("");
    return List.copyOf(names);
  }

  /** How many nodes refer to a name. */
  static long uses(ProgramTree tree, String name) {
    return tree.nodes().stream()
        .filter(node -> TreeNames.waypoints(node.step()).contains(name))
        .count();
  }

  /** A name that is free: {@code prefix} with the smallest number that makes it so. */
  static String free(ProgramTree tree, String prefix) {
    Set<String> taken = TreeNames.all(tree);
    int number = 1;
    while (taken.contains(prefix + number)) {
      number++;
    }
    return prefix + number;
  }
}
