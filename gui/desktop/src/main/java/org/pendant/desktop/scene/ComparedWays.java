package org.pendant.desktop.scene;

import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.pendant.desktop.scene.mesh.Lines;
import org.pendant.models.arm.Joints;
import org.pendant.recording.whatif.TcpWay;

/**
 * Compared ways: the ways of the tool in several variants of a run, and where the arm would be in
 * each at the moment that people look at, each in a colour of its own.
 *
 * @param ways in the order of their names
 * @param ghosts in the same order
 */
public record ComparedWays(List<Way> ways, List<Ghost> ghosts) {
  /** None. */
  public static final ComparedWays NONE = new ComparedWays(List.of(), List.of());

  /** How well those are seen that are not chosen while another one is. */
  private static final double BEHIND = 0.35;

  private static final double GHOST = 0.38;
  private static final double GHOST_CHOSEN = 0.6;
  private static final double GHOST_BEHIND = 0.18;

  /** Copies the lists. */
  public ComparedWays {
    ways = List.copyOf(ways);
    ghosts = List.copyOf(ghosts);
  }

  /**
   * A way.
   *
   * @param name for people
   * @param rgb its colour, 0xRRGGBB
   * @param chosen whether people look at this one
   */
  public record Way(String name, int rgb, boolean chosen, TcpWay points) {}

  /**
   * Where the arm of a variant is.
   *
   * @param name for people
   * @param rgb its colour, 0xRRGGBB
   * @param chosen whether people look at this one
   * @param positionRad of its joints
   */
  public record Ghost(String name, int rgb, boolean chosen, Joints positionRad) {}

  /**
   * What stands in the legend.
   *
   * @param name for people
   * @param rgb its colour, 0xRRGGBB
   * @param chosen whether people look at this one
   */
  public record Entry(String name, int rgb, boolean chosen) {}

  /** Each variant that is to be seen, once. */
  public List<Entry> legend() {
    return Stream.concat(
            ways.stream().map(way -> new Entry(way.name(), way.rgb(), way.chosen())),
            ghosts.stream().map(each -> new Entry(each.name(), each.rgb(), each.chosen())))
        .distinct()
        .toList();
  }

  /** The ghosts in the order in which they are drawn: what is nearer to an eye above the rest. */
  public List<Ghost> drawnGhosts(ToDoubleFunction<Joints> distance) {
    return ghosts.stream()
        .sorted(
            Comparator.comparing(Ghost::chosen)
                .thenComparingDouble(each -> -distance.applyAsDouble(each.positionRad())))
        .toList();
  }

  /** How well a ghost is seen, 0 to 1. */
  public double opacity(Ghost ghost) {
    boolean anyChosen = ghosts.stream().anyMatch(Ghost::chosen);
    return ghost.chosen() ? GHOST_CHOSEN : anyChosen ? GHOST_BEHIND : GHOST;
  }

  /** Whether people look at one of them. */
  public boolean anyChosen() {
    return ways.stream().anyMatch(Way::chosen);
  }

  /** In the order in which they are drawn: the chosen one above all. */
  public List<Way> drawn() {
    return ways.stream().sorted(Comparator.comparing(Way::chosen)).toList();
  }

  /**
   * How wide number {@code i} of {@link #drawn} is, as a share of a usual line: while none is
   * chosen the first one is the widest, so that those that lie on it leave its edges to be seen.
   */
  public double width(int i) {
    if (anyChosen()) {
      return i == ways.size() - 1 ? 2 : 1;
    }
    return ways.size() - i;
  }

  /** The lines of a way. */
  public Lines lines(Way way) {
    boolean behind = !way.chosen() && anyChosen();
    double opacity = behind ? BEHIND : 1;
    TcpWay points = way.points();
    Lines lines = new Lines();
    for (int i = 0; i < points.size(); i++) {
      if (i == 0) {
        lines.from(points.x(i), points.y(i), points.z(i), way.rgb(), opacity);
      } else {
        lines.to(points.x(i), points.y(i), points.z(i), way.rgb(), opacity);
      }
    }
    return lines;
  }
}
