package org.pendant.desktop.scene.view;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/**
 * Label places: where names stand so that each can be read: beside their points if there is room,
 * else a little farther away with a line to the point. None lies on another; what has no room is
 * left out, and so is the name of a point out of sight.
 */
final class LabelPlaces {
  /** Distances from the point that are tried, em. */
  private static final double[] RINGS = {0.7, 2, 3.6, 5.4, 7.5};

  /** Directions that are tried, the usual one first: x to the right and y down. */
  private static final double[][] WAYS = {
    {1, 0.7},
    {1, -0.7},
    {-1, 0.7},
    {-1, -0.7},
    {1, 0},
    {-1, 0},
    {0, 1},
    {0, -1},
    {0.3, 1},
    {-0.3, 1},
    {0.3, -1},
    {-0.3, -1}
  };

  /** To lie on the point of another name is as bad as to be so many rings farther away. */
  private static final int COVERED = 2;

  /** Of a point that has a name of its own, so much stays free, em. */
  private static final double FREE_EM = 0.35;

  /** A name farther than this from its point needs a line to it, em. */
  private static final double LINE_EM = 1.2;

  private final double em;
  private final double high;
  private final ToDoubleFunction<String> wide;
  private final Rectangle2D room;
  private final List<Rectangle2D> taken = new ArrayList<>();
  private final List<Placed> placed = new ArrayList<>();

  /**
   * A name.
   *
   * @param at its point, pixels
   * @param mark number of the waypoint marker; -1 for something else
   * @param chosen whether it must be seen, and comes first
   */
  record Label(String text, Point2D at, int mark, boolean chosen) {}

  /**
   * A name in its place.
   *
   * @param apart whether it needs a line to its point
   */
  record Placed(Label label, Rectangle2D box, boolean apart) {}

  private LabelPlaces(double em, double high, ToDoubleFunction<String> wide, Rectangle2D room) {
    this.em = em;
    this.high = high;
    this.wide = wide;
    this.room = room;
  }

  /**
   * Finds places.
   *
   * @param em size of the font, pixels
   * @param high height of a plate, pixels
   * @param wide width of the plate of a text, pixels
   * @param room the picture
   * @param taken where nothing may stand
   */
  static List<Placed> of(
      List<Label> labels,
      double em,
      double high,
      ToDoubleFunction<String> wide,
      Rectangle2D room,
      List<Rectangle2D> taken) {
    LabelPlaces places = new LabelPlaces(em, high, wide, room);
    places.taken.addAll(taken);
    List<Label> seen =
        labels.stream()
            .filter(each -> room.contains(each.at()))
            .sorted(Comparator.comparing((Label each) -> !each.chosen()))
            .toList();
    seen.forEach(each -> places.place(each, seen));
    return List.copyOf(places.placed);
  }

  private void place(Label label, List<Label> all) {
    List<Rectangle2D> points =
        all.stream().filter(each -> !each.equals(label)).map(each -> around(each.at())).toList();
    Optional<Rectangle2D> free = best(label, points).or(() -> anyway(label));
    if (free.isPresent()) {
      Rectangle2D box = free.get();
      taken.add(box);
      placed.add(new Placed(label, box, distance(box, label.at()) > LINE_EM * em));
    }
  }

  private Rectangle2D around(Point2D point) {
    double free = FREE_EM * em;
    return new Rectangle2D.Double(point.getX() - free, point.getY() - free, 2 * free, 2 * free);
  }

  private Optional<Rectangle2D> best(Label label, List<Rectangle2D> points) {
    Optional<Rectangle2D> best = Optional.empty();
    long least = Long.MAX_VALUE;
    for (int ring = 0; ring < RINGS.length && ring < least; ring++) {
      for (double[] way : WAYS) {
        Rectangle2D box = box(label, RINGS[ring] * em, way);
        long cost = ring + COVERED * points.stream().filter(box::intersects).count();
        if (cost < least && room.contains(box) && taken.stream().noneMatch(box::intersects)) {
          least = cost;
          best = Optional.of(box);
        }
      }
    }
    return best;
  }

  /** A chosen name is seen in any case. */
  private Optional<Rectangle2D> anyway(Label label) {
    if (!label.chosen()) {
      return Optional.empty();
    }
    Rectangle2D box = box(label, RINGS[0] * em, WAYS[0]);
    double x = Math.clamp(box.getX(), 0, Math.max(0, room.getWidth() - box.getWidth()));
    double y = Math.clamp(box.getY(), 0, Math.max(0, room.getHeight() - box.getHeight()));
    return Optional.of(new Rectangle2D.Double(x, y, box.getWidth(), box.getHeight()));
  }

  /** The plate whose nearest corner or edge lies so far from the point. */
  private Rectangle2D box(Label label, double away, double[] way) {
    double width = wide.applyAsDouble(label.text());
    double x = label.at().getX() + way[0] * away - width * (1 - Math.signum(way[0])) / 2;
    double y = label.at().getY() + way[1] * away - high * (1 - Math.signum(way[1])) / 2;
    return new Rectangle2D.Double(x, y, width, high);
  }

  /** From the nearest place of a plate to a point, pixels. */
  static double distance(Rectangle2D box, Point2D point) {
    return nearest(box, point).distance(point);
  }

  /** The place of a plate that is nearest to a point. */
  static Point2D nearest(Rectangle2D box, Point2D point) {
    return new Point2D.Double(
        Math.clamp(point.getX(), box.getMinX(), box.getMaxX()),
        Math.clamp(point.getY(), box.getMinY(), box.getMaxY()));
  }
}
