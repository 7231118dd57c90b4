package org.pendant.project.installation.urp;

import static org.pendant.project.installation.urp.InstallationUrpTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.polyscope.xml.XmlElement;

/** Feature reader: takes features out of the element that contains them. */
final class FeatureReader {
  private static final String POINT = "GeomPoseNode";
  private static final String LINE = "GeomLineNode";
  private static final String PLANE = "GeomPlaneNode";

  private final List<String> remarks;
  private final Set<String> names = new HashSet<>();
  private final List<Feature> features = new ArrayList<>();

  FeatureReader(List<String> remarks) {
    this.remarks = remarks;
  }

  /** All features, in the order of the file. */
  List<Feature> read(XmlElement container) {
    container.forEach(
        each -> {
          boolean named = !each.text("name").isEmpty();
          boolean part = each.text("hiddenSubFeature").equals("true");
          if (named && !part && List.of(POINT, LINE, PLANE).contains(each.name())) {
            add(each);
          }
        });
    return features;
  }

  private void add(XmlElement element) {
    String name = element.text("name");
    FeatureKind kind =
        switch (element.name()) {
          case LINE -> FeatureKind.LINE;
          case PLANE -> FeatureKind.PLANE;
          default -> FeatureKind.POINT;
        };
    Optional<List<Pose>> points = points(element, kind);
    if (!name.matches("[A-Za-z_]\\w*")) {
      leftOut(element, "featureName");
    } else if (points.isEmpty()) {
      leftOut(element, "featureNowhere");
    } else if (!names.add(name)) {
      leftOut(element, "featureTwice");
    } else {
      features.add(
          new Feature(
              name,
              kind,
              points.get(),
              element.text("isVariable").equals("true"),
              element.attribute("joggable").orElse("true").equals("true")));
    }
  }

  private void leftOut(XmlElement feature, String why) {
    remarks.add(text("atLine", feature.line(), text(why, feature.text("name"))));
  }

  private static Optional<List<Pose>> points(XmlElement element, FeatureKind kind) {
    return switch (kind) {
      case POINT -> pose(element).map(List::of);
      case LINE ->
          part(element, "firstPoint")
              .flatMap(first -> part(element, "secondPoint").map(second -> List.of(first, second)));
      case PLANE ->
          part(element, "firstPoint")
              .flatMap(
                  origin ->
                      part(element, "secondPoint")
                          .flatMap(
                              onY ->
                                  part(element, "thirdPoint")
                                      .map(beside -> plane(origin, onY, beside))));
    };
  }

  private static Optional<Pose> part(XmlElement element, String name) {
    return element.child(name).flatMap(each -> each.child(POINT)).flatMap(FeatureReader::pose);
  }

  private static Optional<Pose> pose(XmlElement point) {
    double[] at = row(point, "toolPosition");
    double[] turned = row(point, "toolAxisAngle");
    return at.length == 0 || turned.length == 0
        ? Optional.empty()
        : Optional.of(new Pose(at[0], at[1], at[2], turned[0], turned[1], turned[2]));
  }

  private static double[] row(XmlElement point, String name) {
    return Rows.numbers(point.child(name).map(each -> each.text("value")).orElse(""), 3);
  }

  /**
   * Planes are taught there by their origin, a point on the y axis, and another point of the plane;
   * z is on the side to which the tool pointed at the origin. Here they are known by their origin,
   * a point on the x axis, and one on the side of positive y.
   */
  private static List<Pose> plane(Pose origin, Pose onY, Pose beside) {
    double[] y = between(origin, onY);
    double[] side = between(origin, beside);
    double along = dot(side, y) / Math.max(dot(y, y), Double.MIN_NORMAL);
    double[] tool = between(origin, Poses.trans(origin, new Pose(0, 0, 1, 0, 0, 0)));
    double sign = dot(cross(side, y), tool) < 0 ? -1 : 1;
    Pose onX =
        new Pose(
            origin.x() + sign * (side[0] - along * y[0]),
            origin.y() + sign * (side[1] - along * y[1]),
            origin.z() + sign * (side[2] - along * y[2]),
            origin.rx(),
            origin.ry(),
            origin.rz());
    return List.of(origin, onX, onY);
  }

  private static double[] between(Pose from, Pose to) {
    return new double[] {to.x() - from.x(), to.y() - from.y(), to.z() - from.z()};
  }

  private static double[] cross(double[] a, double[] b) {
    return new double[] {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    };
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
}
