package org.pendant.project.program.urp;

import static org.pendant.project.program.urp.UrpProgramTexts.text;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.NamedTool;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.program.WaypointPosition;

/** Position list: collects the places that were taught. */
final class Positions {
  /** Where we write the pose in full, as files of PolyScope keep the joints alone. */
  static final String OWN_POSE = "pendantPose";

  /** Where we write the feature of such a pose. */
  static final String OWN_FEATURE = "pendantFeature";

  private static final double SAME = 1e-6;

  private final Map<String, WaypointPosition> all = new LinkedHashMap<>();
  private final Map<String, Feature> features = new LinkedHashMap<>();
  private final Map<String, NamedTool> tools = new LinkedHashMap<>();
  private final Optional<XmlElement> programArm;
  private final ArmDescription usualArm;
  private final Remarks remarks;

  /**
   * @param programArm the arm that the program as a whole names
   * @param usualArm taken where nothing else is known
   */
  Positions(Optional<XmlElement> programArm, ArmDescription usualArm, Remarks remarks) {
    this.programArm = programArm;
    this.usualArm = usualArm;
    this.remarks = remarks;
  }

  Map<String, WaypointPosition> all() {
    return all;
  }

  /** Where features were when waypoints were taught in them. */
  List<Feature> features() {
    return List.copyOf(features.values());
  }

  /** The TCPs of moves when their waypoints were taught. */
  List<NamedTool> tools() {
    return List.copyOf(tools.values());
  }

  /** Takes the TCP of a move from the first of its waypoints that says where it is. */
  void addTool(String name, XmlElement move) throws UnreadableFile {
    List<XmlElement> children = move.child("children").map(XmlElement::children).orElse(List.of());
    for (XmlElement each : children) {
      Optional<XmlElement> position = each.child("position");
      Optional<XmlElement> found = position.isPresent() ? position.get().resolved() : position;
      found
          .flatMap(place -> place.child("TCPOffset"))
          .flatMap(offset -> pose(offset, "pose"))
          .ifPresent(pose -> tools.putIfAbsent(name, new NamedTool(name, pose)));
    }
  }

  /**
   * Takes the place of a waypoint.
   *
   * @param waypoint the element with {@code position} in it
   */
  void add(String name, XmlElement waypoint, String feature) throws UnreadableFile {
    Optional<XmlElement> position = waypoint.child("position");
    if (position.isPresent()) {
      add(name, waypoint, position.get(), feature);
    }
  }

  /** Takes a place that stands in an element of its own. */
  void add(String name, XmlElement waypoint, XmlElement position, String feature)
      throws UnreadableFile {
    Optional<XmlElement> found = position.resolved();
    if (found.isEmpty()) {
      remarks.add(position, text("danglingPosition"));
      return;
    }
    Optional<WaypointPosition> read = read(waypoint, found.get(), feature);
    if (read.isEmpty()) {
      remarks.add(position, text("positionWithoutJoints"));
      return;
    }
    WaypointPosition before = all.putIfAbsent(name, read.get());
    if (before != null && before.jointsRad().maxAbsDifference(read.get().jointsRad()) > SAME) {
      remarks.add(position, text("waypointElsewhere", name));
    }
  }

  private Optional<WaypointPosition> read(
      XmlElement waypoint, XmlElement position, String feature) {
    double[] joints =
        Values.numbers(
            position
                .child("JointAngles")
                .map(each -> each.text("angles"))
                .orElse(position.text("joints")));
    if (joints.length != Joints.COUNT) {
      return Optional.empty();
    }
    Joints jointsRad = Joints.of(joints);
    Optional<Pose> baseToFeature =
        waypoint.child("BaseToFeature").flatMap(each -> pose(each, "pose"));
    if (!feature.equals(WaypointPosition.BASE) && !feature.equals(WaypointPosition.TOOL)) {
      baseToFeature.ifPresent(
          pose ->
              features.putIfAbsent(
                  feature, new Feature(feature, FeatureKind.POINT, List.of(pose), false, true)));
    }
    Pose tool = position.child("TCPOffset").flatMap(each -> pose(each, "pose")).orElse(Pose.ZERO);
    Optional<Pose> own = pose(position, OWN_POSE);
    if (own.isPresent()) {
      return Optional.of(
          new WaypointPosition(
              own.get(), position.attribute(OWN_FEATURE).orElse(feature), jointsRad, tool));
    }
    return Optional.of(computed(waypoint, position, feature, baseToFeature, jointsRad, tool));
  }

  private WaypointPosition computed(
      XmlElement waypoint,
      XmlElement position,
      String feature,
      Optional<Pose> baseToFeature,
      Joints jointsRad,
      Pose tool) {
    waypoint.child("outputFlangePose").ifPresent(XmlElement::seeAll);
    Optional<Pose> inFeature =
        waypoint.child("poseInFeatureCoordinates").flatMap(each -> pose(each, "pose"));
    Pose inBase =
        pose(position, "pose")
            .orElseGet(() -> new ForwardKinematics(arm(position)).tcpPose(jointsRad, tool));
    // What is taught while the tool's own frame is chosen is a place all the same.
    String frame = feature.equals(WaypointPosition.TOOL) ? WaypointPosition.BASE : feature;
    if (frame.equals(WaypointPosition.BASE)) {
      return new WaypointPosition(inBase, frame, jointsRad, tool);
    }
    if (inFeature.isPresent()) {
      return new WaypointPosition(inFeature.get(), frame, jointsRad, tool);
    }
    if (baseToFeature.isPresent()) {
      Pose relative = Poses.trans(Poses.inverse(baseToFeature.get()), inBase);
      return new WaypointPosition(relative, frame, jointsRad, tool);
    }
    remarks.add(position, text("featureUnknown", frame));
    return new WaypointPosition(inBase, WaypointPosition.BASE, jointsRad, tool);
  }

  private ArmDescription arm(XmlElement position) {
    return position
        .child("Kinematics")
        .flatMap(each -> Arms.described(each, usualArm))
        .or(() -> programArm.flatMap(each -> Arms.described(each, usualArm)))
        .orElseGet(
            () -> {
              remarks.add(position, text("armNotDescribed"));
              return usualArm;
            });
  }

  private static Optional<Pose> pose(XmlElement element, String attribute) {
    double[] numbers = Values.numbers(element.text(attribute));
    return numbers.length == Pose.SIZE ? Optional.of(Pose.of(numbers)) : Optional.empty();
  }
}
