package org.pendant.desktop.scene.view;

import java.awt.Point;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.TcpTrace;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.scene.WaypointMarkers.Mark;
import org.pendant.desktop.scene.WaypointMarkers.Stop;
import org.pendant.kit.form.Measure;
import org.pendant.models.pose.Pose;

/**
 * Mark finder: which place or way of the program is at a point of the picture: its name, its point,
 * or the line that leads to it.
 */
final class MarkFinder {
  private static final double NEAR_POINT_PX = 9;
  private static final double NEAR_LINE_PX = 5;

  private final PictureRequest shown;
  private final WaypointMarkers markers;
  private final int width;
  private final int height;
  private final List<LabelPlaces.Placed> labels;
  private final Function<Pose, String> words;

  /**
   * What is seen.
   *
   * @param labels names and where they stand
   * @param words how people read a pose, in lines
   */
  MarkFinder(
      PictureRequest shown,
      int width,
      int height,
      List<LabelPlaces.Placed> labels,
      Function<Pose, String> words) {
    this.shown = shown;
    markers = shown.model().waypointMarkers();
    this.width = width;
    this.height = height;
    this.labels = labels;
    this.words = words;
  }

  /** Where a pose is seen; empty behind the eye. */
  private Optional<Point2D> pixel(Pose pose) {
    return shown.camera().pixel(new Vector3(pose.x(), pose.y(), pose.z()), width, height);
  }

  /** What is at a point. */
  Optional<MarkTarget> at(Point point) {
    return named(point).or(() -> place(point)).or(() -> way(point)).or(() -> trace(point));
  }

  private Optional<MarkTarget> named(Point point) {
    for (LabelPlaces.Placed each : labels) {
      int mark = each.label().mark();
      if (mark >= 0 && mark < markers.marks().size() && each.box().contains(point)) {
        return Optional.of(target(mark, each.label().at()));
      }
    }
    return Optional.empty();
  }

  private Optional<MarkTarget> place(Point point) {
    for (int i = 0; i < markers.marks().size(); i++) {
      Optional<Point2D> at = pixel(markers.marks().get(i).inBase());
      if (at.isPresent() && at.get().distance(point) < NEAR_POINT_PX) {
        return Optional.of(target(i, at.get()));
      }
    }
    return Optional.empty();
  }

  private MarkTarget target(int number, Point2D at) {
    Mark mark = markers.marks().get(number);
    Optional<Stop> stop = markers.next(number);
    String how = stop.map(each -> "\n" + each.how()).orElse("");
    String text = mark.name() + "\n" + words.apply(mark.inBase()) + how;
    return new MarkTarget(
        text, stop.map(Stop::node).orElse(0L), 0, Double.NaN, at, Optional.empty());
  }

  private Optional<MarkTarget> way(Point point) {
    Optional<MarkTarget> nearest = Optional.empty();
    double nearestPx = NEAR_LINE_PX;
    for (Line line : lines()) {
      double px =
          Line2D.ptSegDist(
              line.from.getX(), line.from.getY(), line.to.getX(), line.to.getY(), point.x, point.y);
      if (px < nearestPx) {
        nearestPx = px;
        nearest = Optional.of(line.target());
      }
    }
    return nearest;
  }

  /** Where the tool was. */
  private Optional<MarkTarget> trace(Point point) {
    TcpTrace trace = shown.model().trace();
    Optional<MarkTarget> nearest = Optional.empty();
    double nearestPx = NEAR_LINE_PX;
    for (int i = 0; i < trace.size(); i++) {
      Optional<Point2D> at =
          shown.camera().pixel(new Vector3(trace.x(i), trace.y(i), trace.z(i)), width, height);
      if (at.isPresent() && at.get().distance(point) < nearestPx) {
        nearestPx = at.get().distance(point);
        nearest = Optional.of(target(trace, i, at.get()));
      }
    }
    return nearest;
  }

  private static MarkTarget target(TcpTrace trace, int i, Point2D at) {
    String speed = Measure.MILLIMETRE_PER_S.brief(trace.speedMPerS(i)) + " mm/s";
    String line = trace.line(i) == 0 ? "" : "Line " + trace.line(i) + "\n";
    String margin =
        trace
            .colouring()
            .map(
                each ->
                    "\n" + Math.round(100 * trace.used(i)) + " % of the margin: " + each.words())
            .orElse("");
    String words = line + speed + margin + "\nA click explains the speed";
    return new MarkTarget(words, 0, trace.line(i), trace.timeS(i), at, Optional.empty());
  }

  /** The way to the node that is chosen. */
  List<MarkTarget> chosenWays() {
    return lines().stream().filter(each -> each.stop.chosen()).map(Line::target).toList();
  }

  private List<Line> lines() {
    List<Line> lines = new ArrayList<>();
    for (List<Stop> way : markers.ways()) {
      for (int i = 1; i < way.size(); i++) {
        Mark before = markers.marks().get(way.get(i - 1).mark());
        Stop stop = way.get(i);
        Mark mark = markers.marks().get(stop.mark());
        Optional<Point2D> from = pixel(before.inBase());
        Optional<Point2D> to = pixel(mark.inBase());
        if (from.isPresent() && to.isPresent()) {
          lines.add(new Line(before.name(), mark.name(), stop, from.get(), to.get()));
        }
      }
    }
    return lines;
  }

  private record Line(String begin, String end, Stop stop, Point2D from, Point2D to) {
    MarkTarget target() {
      String text = begin + " \u2192 " + end + "\n" + stop.how();
      return new MarkTarget(text, stop.node(), 0, Double.NaN, to, Optional.of(from));
    }
  }
}
