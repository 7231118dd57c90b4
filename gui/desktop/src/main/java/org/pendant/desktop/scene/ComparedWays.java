package org.pendant.desktop.scene;

import java.util.Comparator;
import java.util.List;
import org.pendant.desktop.scene.mesh.Lines;
import org.pendant.recording.whatif.TcpWay;

/**
 * Compared ways: the ways of the tool in several variants of a run, each in a colour of its own.
 *
 * @param ways in the order of their names
 */
public record ComparedWays(List<Way> ways) {
  /** None. */
  public static final ComparedWays NONE = new ComparedWays(List.of());

  /** How well those are seen that are not chosen while another one is. */
  private static final double BEHIND = 0.35;

  /** Copies the list. */
  public ComparedWays {
    ways = List.copyOf(ways);
  }

  /**
   * A way.
   *
   * @param name for people
   * @param rgb its colour, 0xRRGGBB
   * @param chosen whether people look at this one
   */
  public record Way(String name, int rgb, boolean chosen, TcpWay points) {}

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
