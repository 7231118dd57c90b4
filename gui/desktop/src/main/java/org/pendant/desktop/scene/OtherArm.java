package org.pendant.desktop.scene;

import java.util.List;
import org.joml.Matrix4f;
import org.pendant.controller.world.SceneObject;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;

/**
 * Another arm of the cell, as it stands beside the one that the picture is about; immutable.
 *
 * @param name what the cell calls it
 * @param arm its shape is known by its id
 * @param kinematics of this very arm, calibration included
 * @param positionRad where its joints are, rad
 * @param tcpInFlange its tool centre point, m and rad
 * @param baseInScene where its base stands, in the frame of the picture
 * @param grippers on its flange
 * @param toolBodies what else is on its flange, in the flange's frame
 * @param hitLinks links of it that have hit something, or that another arm has hit, as stops call
 *     them
 */
public record OtherArm(
    String name,
    ArmDescription arm,
    ForwardKinematics kinematics,
    Joints positionRad,
    Pose tcpInFlange,
    Pose baseInScene,
    List<DeviceSight.Gripper> grippers,
    List<SceneObject> toolBodies,
    List<String> hitLinks) {
  /** Copies the lists. */
  public OtherArm {
    grippers = List.copyOf(grippers);
    toolBodies = List.copyOf(toolBodies);
    hitLinks = List.copyOf(hitLinks);
  }

  /** Where its links are, in the frame of the picture. */
  public LinkPlaces places() {
    return new LinkPlaces(kinematics, arm.dh(), positionRad, LinkPlaces.matrix(baseInScene));
  }

  /** Where the meshes of its grippers are. */
  public List<List<Matrix4f>> gripperPlaces(LinkPlaces places) {
    return GripperPlaces.of(grippers, tcpInFlange, places);
  }
}
