package org.pendant.project.program.urp;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.installation.Installation;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.polyscope.xml.XmlText;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

/**
 * Motion elements: begins the elements of steps that move the arm, with all that is in them but
 * other nodes.
 */
final class MotionElements {
  private static final String TURN_STOP_RAD_PER_S2 = "34.90658503988659";

  private final XmlText out;
  private final StepElements elements;
  private final Map<String, WaypointPosition> places;
  private final Installation installation;
  private final DhLengths arm;

  MotionElements(
      XmlText out,
      StepElements elements,
      Map<String, WaypointPosition> places,
      Installation installation) {
    this.out = out;
    this.elements = elements;
    this.places = places;
    this.installation = installation;
    arm = Arms.of(installation.robot()).dh();
  }

  /**
   * Begins the element of a step.
   *
   * @return whether there is one; if not, nothing was written
   */
  boolean open(MotionStep step, Within within) {
    switch (step) {
      case MotionStep.Move move -> move(move);
      case MotionStep.Waypoint waypoint -> waypoint(waypoint, within);
      case MotionStep.CircleMove circle -> {
        out.open("CircleMove");
        out.attribute("OrientationMode", circle.fixedOrientation() ? "Fixed" : "Unconstrained");
        elements.optional("blendRadius", circle.blendRadiusM());
      }
      case MotionStep.Direction direction -> {
        return direction(direction);
      }
      case MotionStep.Until until -> until(until.rule());
      case MotionStep.Home home -> home(home);
    }
    return true;
  }

  /** What a step says of the nodes in it. */
  static Within inside(MotionStep.Move move) {
    return new Within(
        move.kind(),
        move.speed(),
        move.acceleration(),
        move.feature(),
        OptionalDouble.empty(),
        false);
  }

  private void move(MotionStep.Move move) {
    String type =
        switch (move.kind()) {
          case JOINT -> "MoveJ";
          case LINEAR -> "MoveL";
          case PROCESS -> "MoveP";
        };
    out.open("Move", "motionType", type);
    out.attribute("speed", Double.toString(move.speed()));
    out.attribute("acceleration", Double.toString(move.acceleration()));
    boolean active = move.tool() instanceof ToolChoice.Active;
    out.attribute("useActiveTCP", Boolean.toString(active));
    out.attribute("positionType", move.byJoints() ? "JointAngles" : "CartesianPose");
    if (move.tool() instanceof ToolChoice.Named named) {
      out.leaf("tcp", "referencedName", named.name());
    }
    featureOf(move.feature());
  }

  private void waypoint(MotionStep.Waypoint waypoint, Within within) {
    switch (waypoint.target()) {
      case WaypointTarget.Fixed fixed -> {
        out.open("Waypoint", "type", "Fixed", "name", fixed.name(), "kinematicsFlags", "4");
        parameters(waypoint, within);
        place(MotionReader.TO, fixed.name(), within.feature());
        out.leaf("BaseToFeature", "pose", Values.text(feature(within.feature()).toArray()));
      }
      case WaypointTarget.Relative relative -> {
        out.open("Waypoint", "type", "Relative", "name", relative.name());
        out.attribute("kinematicsFlags", "4");
        parameters(waypoint, within);
        place(MotionReader.FROM, relative.from(), within.feature());
        place(MotionReader.TO, relative.to(), within.feature());
      }
      case WaypointTarget.Variable variable -> {
        out.open("Waypoint", "type", "Variable", "name", "", "kinematicsFlags", "-1");
        parameters(waypoint, within);
        if (installation.feature(variable.expression()).isPresent()) {
          out.leaf("variable", ExpressionReader.FEATURE, variable.expression());
        } else if (StepElements.isName(variable.expression())) {
          elements.variable("variable", variable.expression());
        } else {
          elements.expression("expression", variable.expression());
        }
      }
    }
  }

  /** Both speeds stand there or none. */
  private boolean direction(MotionStep.Direction direction) {
    if (direction.speedMPerS().isPresent() != direction.accelerationMPerS2().isPresent()) {
      return false;
    }
    out.open(MotionReader.DIRECTION);
    Optional<String> axis = axis(direction);
    if (axis.isPresent()) {
      out.attribute(MotionReader.AXIS_NAME, axis.get());
    }
    if (direction.speedMPerS().isPresent()) {
      out.attribute(
          MotionReader.OWN_SPEEDS,
          Values.text(
              direction.speedMPerS().getAsDouble(), direction.accelerationMPerS2().getAsDouble()));
    }
    if (axis.isEmpty()) {
      elements.expression(
          "expression",
          direction.expression().isEmpty()
              ? "[" + Values.text(direction.x(), direction.y(), direction.z()) + "]"
              : direction.expression());
    }
    featureOf(direction.feature());
    return true;
  }

  private void featureOf(String name) {
    out.leaf("feature", "class", "GeomFeatureReference", "referencedName", Features.there(name));
  }

  /** The word for a direction of length 1 along an axis; empty for others. */
  private static Optional<String> axis(MotionStep.Direction direction) {
    if (!direction.expression().isEmpty()) {
      return Optional.empty();
    }
    double[] vector = {direction.x(), direction.y(), direction.z()};
    for (int i = 0; i < vector.length; i++) {
      double others = Math.hypot(vector[(i + 1) % 3], vector[(i + 2) % 3]);
      if (others == 0 && Math.abs(vector[i]) == 1) {
        return Optional.of("XYZ".charAt(i) + (vector[i] > 0 ? "Plus" : "Minus"));
      }
    }
    return Optional.empty();
  }

  private void parameters(MotionStep.Waypoint waypoint, Within within) {
    out.open("motionParameters");
    switch (waypoint.timing()) {
      case Timing.AsMove _ -> {
        // the attributes are left out
      }
      case Timing.Own own -> {
        String sort = within.kind() == MoveKind.JOINT ? "joint" : "cartesian";
        out.attribute(sort + "Speed", Double.toString(own.speed()));
        out.attribute(sort + "Acceleration", Double.toString(own.acceleration()));
      }
      case Timing.Duration duration ->
          out.attribute(MotionReader.MOTION_TIME, Double.toString(duration.timeS()));
    }
    elements.optional("blendRadius", waypoint.blendRadiusM());
    out.close();
  }

  /** A place that was taught; nothing for one that was not. */
  private void place(String element, String name, String feature) {
    WaypointPosition place = places.get(name);
    if (place == null || !out.first(element, "place " + name)) {
      return;
    }
    out.open(element, Positions.OWN_POSE, Values.text(place.tcp().toArray()));
    if (!place.feature().equals(feature)) {
      out.attribute(Positions.OWN_FEATURE, place.feature());
    }
    out.leaf("JointAngles", "angles", Values.text(place.jointsRad().toArray()));
    out.leaf("TCPOffset", "pose", Values.text(place.toolInFlange().toArray()));
    kinematics("Kinematics");
    out.close();
  }

  /** The lengths of the arm; robots take their own ones in place of these. */
  void kinematics(String element) {
    out.open(element, "status", "NOT_INITIALIZED", "validChecksum", "false");
    out.leaf("deltaTheta", "value", Values.text(Joints.ZERO.toArray()));
    out.leaf("a", "value", Values.text(0, arm.a2(), arm.a3(), 0, 0, 0));
    out.leaf("d", "value", Values.text(arm.d1(), 0, 0, arm.d4(), arm.d5(), arm.d6()));
    out.leaf("alpha", "value", Values.text(Math.PI / 2, 0, 0, Math.PI / 2, -Math.PI / 2, 0));
    out.leaf("jointChecksum", "value", "-1, -1, -1, -1, -1, -1");
    out.close();
  }

  private Pose feature(String name) {
    return installation.feature(name).flatMap(FeaturePoses::pose).orElse(Pose.ZERO);
  }

  private void until(UntilRule rule) {
    switch (rule) {
      case UntilRule.Distance distance -> {
        boolean blends = distance.blendRadiusM().isPresent();
        out.open("Until", MotionReader.UNTIL_TYPE, "DISTANCE");
        out.attribute(MotionReader.DISTANCE_ENDS, blends ? MotionReader.BLENDS : "STOP");
        out.text(MotionReader.DISTANCE, Double.toString(distance.distanceM()));
        if (blends) {
          out.open("motionParameters");
          elements.optional("blendRadius", distance.blendRadiusM());
          out.close();
        }
      }
      case UntilRule.Expression expression -> {
        out.open("Until", "type", "Expression");
        elements.expression("expression", expression.condition());
      }
      case UntilRule.DigitalInput input -> {
        out.open("Until", "type", "DigitalInput");
        elements.pin(input.signal());
        out.text("digitalValue", input.level() ? "1" : "0");
      }
      case UntilRule.Contact contact -> {
        out.open("Until", MotionReader.UNTIL_TYPE, MotionReader.CONTACT);
        out.attribute(MotionReader.RETRACTION, Double.toString(contact.retractM()));
        out.attribute(MotionReader.CONTACT_STOP, Double.toString(contact.stopDecelerationMPerS2()));
        out.attribute("decelerationAngularAcceleration", TURN_STOP_RAD_PER_S2);
      }
    }
  }

  private void home(MotionStep.Home home) {
    out.open("SafeHome");
    out.attribute("speed", Double.toString(home.speedRadPerS()));
    out.attribute("acceleration", Double.toString(home.accelerationRadPerS2()));
    out.attribute(
        "positionOptionType", home.timeS().isPresent() ? "TIME" : "SPEED_AND_ACCELERATION");
    elements.optional(MotionReader.MOTION_TIME, home.timeS());
  }
}
