package org.pendant.desktop.scene;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4fc;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Joint frames: the frames that turn with the joints, z along the axis of each; the last is the
 * flange's.
 */
public final class JointFrames {
  private static final List<Link> TURNING =
      List.of(
          Link.SHOULDER, Link.UPPER_ARM, Link.FOREARM, Link.WRIST_1, Link.WRIST_2, Link.WRIST_3);

  private JointFrames() {}

  /** The six frames of an arm at these joint positions, rad, in the base frame. */
  public static List<Pose> of(ForwardKinematics kinematics, DhLengths dh, Joints positionRad) {
    LinkPlaces places = new LinkPlaces(kinematics, dh, positionRad);
    List<Pose> frames = new ArrayList<>();
    for (Link link : TURNING) {
      frames.add(pose(places.of(link)));
    }
    return frames;
  }

  /** JOML keeps columns, a transform rows. */
  private static Pose pose(Matrix4fc m) {
    return Transforms.toPose(
        new double[] {
          m.m00(), m.m10(), m.m20(),
          m.m01(), m.m11(), m.m21(),
          m.m02(), m.m12(), m.m22(),
          m.m30(), m.m31(), m.m32()
        });
  }
}
