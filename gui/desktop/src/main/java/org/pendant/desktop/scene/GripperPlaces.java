package org.pendant.desktop.scene;

import java.util.List;
import org.joml.Matrix4f;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.models.pose.Pose;

/** Gripper places: where the meshes of a gripper are, in the base frame. */
public final class GripperPlaces {
  private GripperPlaces() {}

  /**
   * For each gripper a place for each mesh of {@link org.pendant.desktop.scene.mesh.GripperMesh}.
   * What is not to be seen has no size.
   *
   * @param places of the links of the arm
   */
  public static List<List<Matrix4f>> of(SceneModel model, LinkPlaces places) {
    return of(model.devices().grippers(), model.tcpInFlange(), places);
  }

  /** As {@link #of(SceneModel, LinkPlaces)}, of the grippers of one arm. */
  static List<List<Matrix4f>> of(
      List<DeviceSight.Gripper> grippers, Pose tcpInFlange, LinkPlaces places) {
    return grippers.stream()
        .map(gripper -> of(gripper, new Matrix4f(places.of(Link.WRIST_3)), tcpInFlange))
        .toList();
  }

  private static List<Matrix4f> of(DeviceSight.Gripper gripper, Matrix4f flange, Pose tcpInFlange) {
    Matrix4f hand = new Matrix4f(flange).mul(LinkPlaces.matrix(gripper.inFlange(tcpInFlange)));
    return List.of(
        flange,
        hand,
        finger(hand, gripper, 0.5),
        finger(hand, gripper, -0.5),
        new Matrix4f(hand)
            .scale(
                gripper.partWidthM() > 0 ? 1 : 0,
                (float) gripper.partWidthM(),
                gripper.partWidthM() > 0 ? 1 : 0));
  }

  private static Matrix4f finger(Matrix4f hand, DeviceSight.Gripper gripper, double share) {
    return gripper.openingM().isPresent()
        ? new Matrix4f(hand).translate(0, (float) (share * gripper.openingM().getAsDouble()), 0)
        : new Matrix4f(hand).scale(0);
  }
}
