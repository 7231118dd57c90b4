package org.pendant.desktop.scene.view;

import static org.pendant.desktop.scene.view.PictureTexts.text;

import java.awt.Point;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.IntToDoubleFunction;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.TcpTrace;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.scene.WaypointMarkers.Mark;
import org.pendant.desktop.scene.WaypointMarkers.Stop;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.form.Measure;
import org.pendant.models.pose.Pose;

/**
 * Mark finder: which place or way of the program is at a point of the picture: its name, its point,
 * or the line that leads to it.
 */
final class MarkFinder {
  private static final double NEAR_POINT_PX = 9;
  private static final double NEAR_LINE_PX = 5;
  private static final double ONE_PX = 1;

  private final PictureRequest shown;
  private final WaypointMarkers markers;
  private final int width;
  private final int height;
  private final List<LabelPlaces.Placed> labels;
  private final PoseForm form;
  private final IntFunction<String> places;

  /**
   * What is seen.
   *
   * @param labels names and where they stand
   * @param form in which people read poses and speeds
   * @param places what a line is called, such as {@code Line 12}
   */
  MarkFinder(
      PictureRequest shown,
      int width,
      int height,
      List<LabelPlaces.Placed> labels,
      PoseForm form,
      IntFunction<String> places) {
    this.shown = shown;
    markers = shown.model().waypointMarkers();
    this.width = width;
    this.height = height;
    this.labels = labels;
    this.form = form;
    this.places = places;
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
    String text = mark.name() + "\n" + form.words(mark.inBase()) + how;
    return new MarkTarget(
        text, stop.map(Stop::node).orElse(mark.node()), 0, Double.NaN, at, Optional.empty());
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

  /** Where the tool or the elbow was. */
  private Optional<MarkTarget> trace(Point point) {
    TcpTrace tool = shown.model().trace();
    Optional<Traced> nearest = nearest(tool, "", point, NEAR_LINE_PX);
    return tool.elbow()
        .flatMap(
            elbow ->
                nearest(
                    elbow,
                    text("elbow") + "\n",
                    point,
                    nearest.map(Traced::px).orElse(NEAR_LINE_PX)))
        .or(() -> nearest)
        .map(this::target);
  }

  /** The place on a way that is the nearest to a point of the picture, if that is near enough. */
  private Optional<Traced> nearest(TcpTrace trace, String what, Point point, double withinPx) {
    Optional<Traced> nearest = Optional.empty();
    double nearestPx = withinPx;
    Optional<Point2D> before = Optional.empty();
    for (int i = 0; i < trace.size(); i++) {
      Optional<Point2D> at =
          shown.camera().pixel(new Vector3(trace.x(i), trace.y(i), trace.z(i)), width, height);
      if (at.isPresent()) {
        Point2D from = trace.begins(i) ? at.get() : before.orElse(at.get());
        double share = share(from, at.get(), point);
        Point2D place =
            new Point2D.Double(
                between(from.getX(), at.get().getX(), share),
                between(from.getY(), at.get().getY(), share));
        double px = place.distance(point);
        if (px < nearestPx) {
          nearestPx = px;
          nearest = Optional.of(new Traced(trace, what, i, share, place, px));
        }
      }
      before = at;
    }
    return nearest;
  }

  /**
   * How far along a piece of a line the place is that is the nearest to a point, 0 to 1: its ends
   * are taken for where they are as long as nobody can tell.
   */
  private static double share(Point2D from, Point2D to, Point point) {
    double lengthPx = from.distance(to);
    if (to.distance(point) <= ONE_PX || lengthPx <= ONE_PX) {
      return 1;
    }
    if (from.distance(point) <= ONE_PX) {
      return 0;
    }
    double x = (point.x - from.getX()) * (to.getX() - from.getX());
    double y = (point.y - from.getY()) * (to.getY() - from.getY());
    return Math.clamp((x + y) / (lengthPx * lengthPx), 0, 1);
  }

  private static double between(double from, double to, double share) {
    return from + share * (to - from);
  }

  /**
   * A place on a way, and how far the pointer is from it.
   *
   * @param i the point at the end of the piece that it is on
   * @param share how far along that piece, 0 to 1
   */
  private record Traced(TcpTrace trace, String what, int i, double share, Point2D at, double px) {
    private double of(IntToDoubleFunction number) {
      return share == 1
          ? number.applyAsDouble(i)
          : between(number.applyAsDouble(i - 1), number.applyAsDouble(i), share);
    }
  }

  private MarkTarget target(Traced traced) {
    TcpTrace trace = traced.trace();
    int i = traced.i();
    String speed = "\n" + TraceScale.speed(trace.speedMPerS(i), form);
    String line =
        trace.line(i) == 0
            ? ""
            : places.apply(trace.line(i)) + ", " + Measure.SECOND.words(trace.stretchS(i)) + "\n";
    String margin =
        trace
            .colouring()
            .map(each -> "\n" + TraceScale.margin(each, trace.used(i), form))
            .orElse("");
    String place = form.place(traced.of(trace::x), traced.of(trace::y), traced.of(trace::z));
    String words = text("aClickExplainsTheSpeed", traced.what() + line + place + speed + margin);
    return new MarkTarget(
        words, 0, trace.line(i), traced.of(trace::timeS), traced.at(), Optional.empty());
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
