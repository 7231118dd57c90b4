package org.pendant.desktop.scene;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.desktop.scene.mesh.Lines;
import org.pendant.models.pose.Pose;

/**
 * Waypoint markers: the places that a program moves to, and their order; immutable.
 *
 * @param marks each place once
 * @param ways stops that follow each other
 */
public record WaypointMarkers(List<Mark> marks, List<List<Stop>> ways) {
  /** No places. */
  public static final WaypointMarkers NONE = new WaypointMarkers(List.of(), List.of());

  private static final double DASH_M = 0.02;
  private static final int MAX_DASHES = 100;
  private static final int LIGHT_RGB = 0x6A45B5;
  private static final int DARK_RGB = 0xC4AEFF;

  /**
   * A place.
   *
   * @param inBase pose of the TCP there
   * @param chosen whether the user looks at it just now
   * @param node key of the first node that names it, such as the pattern that it is a corner of; 0
   *     for none
   */
  public record Mark(String name, Pose inBase, boolean chosen, long node) {}

  /**
   * A stop: the program goes to a place.
   *
   * @param mark number of the place, from 0
   * @param node key of the node that goes there
   * @param how it does, such as {@code MoveL at 250 mm/s}
   * @param chosen whether the user looks at the node just now
   */
  public record Stop(int mark, long node, String how, boolean chosen) {}

  /** Copies the lists. */
  public WaypointMarkers {
    marks = List.copyOf(marks);
    ways = ways.stream().map(List::copyOf).toList();
  }

  /** The stop at a place; after the one that is chosen there the next one. */
  public Optional<Stop> next(int mark) {
    return after(stops().filter(each -> each.mark() == mark).toList(), 1);
  }

  /** The stop so many further on than the one that is chosen; empty without stops. */
  public Optional<Stop> stepped(int by) {
    return after(stops().toList(), by);
  }

  private Stream<Stop> stops() {
    return ways.stream().flatMap(List::stream);
  }

  private static Optional<Stop> after(List<Stop> stops, int by) {
    if (stops.isEmpty()) {
      return Optional.empty();
    }
    for (int i = 0; i < stops.size(); i++) {
      if (stops.get(i).chosen()) {
        return Optional.of(stops.get(Math.floorMod(i + by, stops.size())));
      }
    }
    return Optional.of(by > 0 ? stops.getFirst() : stops.getLast());
  }

  /** Dashed lines from each place to the next one. */
  public Lines lines(SceneTheme theme) {
    Lines lines = new Lines();
    int rgb = theme == SceneTheme.LIGHT ? LIGHT_RGB : DARK_RGB;
    for (List<Stop> way : ways) {
      for (int i = 1; i < way.size(); i++) {
        dash(
            marks.get(way.get(i - 1).mark()).inBase(),
            marks.get(way.get(i).mark()).inBase(),
            rgb,
            lines);
      }
    }
    return lines;
  }

  private static void dash(Pose from, Pose to, int rgb, Lines lines) {
    double[] way = {to.x() - from.x(), to.y() - from.y(), to.z() - from.z()};
    double lengthM = Math.hypot(Math.hypot(way[0], way[1]), way[2]);
    // An odd number of stretches, so that both ends have a dash.
    int stretches = 2 * Math.clamp(Math.round(lengthM / (2 * DASH_M)), 0, MAX_DASHES) + 1;
    for (int i = 0; i < stretches; i += 2) {
      double begin = i / (double) stretches;
      double end = (i + 1) / (double) stretches;
      lines.from(
          from.x() + begin * way[0], from.y() + begin * way[1], from.z() + begin * way[2], rgb, 1);
      lines.to(from.x() + end * way[0], from.y() + end * way[1], from.z() + end * way[2], rgb, 1);
    }
  }
}
