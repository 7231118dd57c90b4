package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.List;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.world.SceneObject;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.function.Call;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

/**
 * Goal of optimovej and optimovel (manual 15.32). Frames are {@code base}; {@code flange} and
 * {@code tcp} as they stand when the move begins; and the objects of the scene, which serve as the
 * world model: a box by its pose, a sphere and a plane by the point they are given by.
 */
final class MoveGoal {
  private static final List<String> MEMBERS = List.of("pose", "frame");

  private final ForwardKinematics forward;
  private final ReferenceFrame frame;
  private final Pose frameInBase;
  private final Pose tcp;
  private final Pose pose;

  private enum ReferenceFrame {
    FIXED,
    FLANGE,
    TCP
  }

  private MoveGoal(ControlBox box, ReferenceFrame frame, Pose frameInBase, Pose pose) {
    forward = box.kinematics().forward();
    tcp = box.flange().tool().inFlange();
    this.frame = frame;
    this.frameInBase = frameInBase;
    this.pose = pose;
  }

  /** The goal that argument {@code index} of a call names. */
  static MoveGoal of(Call<ControlBox> call, int index) throws ScriptError {
    ControlBox box = call.host();
    return switch (call.kind(index)) {
      case POSE ->
          new MoveGoal(box, ReferenceFrame.FIXED, Pose.ZERO, MotionArguments.pose(call, index));
      case LIST ->
          new MoveGoal(
              box,
              ReferenceFrame.FIXED,
              Pose.ZERO,
              box.kinematics()
                  .forward()
                  .tcpPose(MotionArguments.jointGoal(call, index), box.flange().tool().inFlange()));
      case STRUCT -> inFrame(call, index, call.struct(index));
      case STRING ->
          new MoveGoal(box, ReferenceFrame.FIXED, object(call, call.text(index)), Pose.ZERO);
      case NONE, BOOL, INT, FLOAT, MATRIX, HANDLE -> throw call.wrongKind(index, text("goals"));
    };
  }

  private static MoveGoal inFrame(Call<ControlBox> call, int index, StructValue struct)
      throws ScriptError {
    if (!struct.names().containsAll(MEMBERS)
        || !(struct.get("pose") instanceof PoseValue pose)
        || !(struct.get("frame") instanceof StringValue name)) {
      throw call.wrongKind(index, text("poseInFrame"));
    }
    Pose given = MotionArguments.finite(call, index, pose.pose());
    ControlBox box = call.host();
    return switch (name.bytes()) {
      case "base" -> new MoveGoal(box, ReferenceFrame.FIXED, Pose.ZERO, given);
      case "flange" -> new MoveGoal(box, ReferenceFrame.FLANGE, Pose.ZERO, given);
      case "tcp" -> new MoveGoal(box, ReferenceFrame.TCP, Pose.ZERO, given);
      default -> new MoveGoal(box, ReferenceFrame.FIXED, object(call, name.bytes()), given);
    };
  }

  /** The pose of an object of the scene, in the base frame. */
  private static Pose object(Call<ControlBox> call, String name) throws ScriptError {
    for (SceneObject each : call.host().arm().scene().objects()) {
      if (each.name().equals(name)) {
        return each.poseInBase();
      }
    }
    throw call.failure("unknown-object", text("noObject", Value.of(name).text()));
  }

  /**
   * The goal of the TCP in the base frame.
   *
   * @param from joint positions where the move begins, rad
   */
  Pose inBase(Joints from) {
    Pose reference =
        switch (frame) {
          case FIXED -> frameInBase;
          case FLANGE -> forward.tcpPose(from, Pose.ZERO);
          case TCP -> forward.tcpPose(from, tcp);
        };
    return Poses.trans(reference, pose);
  }
}
