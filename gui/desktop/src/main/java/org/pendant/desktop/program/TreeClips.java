package org.pendant.desktop.program;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.pendant.project.program.PlaceNames;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.TreeNames;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.text.Clip;
import org.pendant.project.program.text.ProgramText;

/** Tree clips: nodes on the clipboard, as text, with the places that they refer to. */
final class TreeClips {
  private TreeClips() {}

  /** The text of nodes of a tree. */
  static String write(ProgramTree tree, List<ProgramNode> nodes) {
    Map<String, WaypointPosition> places = new LinkedHashMap<>();
    for (String name : places(nodes)) {
      WaypointPosition place = tree.waypoints().get(name);
      if (place != null) {
        places.put(name, place);
      }
    }
    return ProgramText.writeClip(nodes, places);
  }

  private static Set<String> places(List<ProgramNode> nodes) {
    Set<String> names = new LinkedHashSet<>();
    for (ProgramNode each : nodes) {
      names.addAll(TreeNames.waypoints(each.step()));
      names.addAll(places(each.children()));
    }
    return names;
  }

  /**
   * The tree with a clip put in. Places that it knows stay shared; those that mean somewhere else
   * than the clip's get another name there.
   */
  static ProgramTree paste(ProgramTree tree, Clip clip, Spot spot) {
    Map<String, String> renamed = new HashMap<>();
    Map<String, WaypointPosition> places = new LinkedHashMap<>(tree.waypoints());
    Set<String> taken = new LinkedHashSet<>(TreeNames.all(tree));
    taken.addAll(clip.waypoints().keySet());
    clip.waypoints()
        .forEach(
            (name, place) -> {
              WaypointPosition there = tree.waypoints().get(name);
              String to = there == null || there.equals(place) ? name : free(name, taken);
              renamed.put(name, to);
              places.putIfAbsent(to, place);
            });
    List<ProgramNode> nodes =
        clip.nodes().stream().map(each -> PlaceNames.renamed(each, renamed)).toList();
    return tree.withWaypoints(places).insert(spot.parent(), spot.index(), nodes);
  }

  /** A name like {@code name} that is not used; taken from now on. */
  private static String free(String name, Set<String> taken) {
    String start = name.replaceFirst("_\\d+$", "");
    int number = 1;
    while (!taken.add(start + "_" + number)) {
      number++;
    }
    return start + "_" + number;
  }
}
