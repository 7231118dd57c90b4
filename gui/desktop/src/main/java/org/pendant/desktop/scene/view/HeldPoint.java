package org.pendant.desktop.scene.view;

import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.Picked;
import org.pendant.desktop.scene.Ray;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Transforms;

/**
 * Grabbed point of the arm that the pointer holds, and the plane in which it drags it: parallel to
 * the screen, through where the point was grabbed.
 *
 * @param link the link that joint 0 to 5 moves
 * @param inLinkM the point in the Denavit-Hartenberg frame after that joint, m
 * @param grabbedInBaseM where it was grabbed, in the base frame, m
 * @param towardsScene direction in which the camera looked then
 */
record HeldPoint(int link, Vector3 inLinkM, Vector3 grabbedInBaseM, Vector3 towardsScene) {
  /** What was picked, as something to hold; empty for what does not move. */
  static Optional<HeldPoint> of(Picked picked, SceneModel model, Camera camera) {
    OptionalInt found =
        switch (picked) {
          case Picked.OnLink on -> joint(on.link());
          case Picked.OnTcp _ -> OptionalInt.of(Joints.COUNT - 1);
          case Picked.OnObject _ -> OptionalInt.empty();
        };
    if (found.isEmpty()) {
      return Optional.empty();
    }
    int link = found.getAsInt();
    Vector3 point = picked.pointInBaseM();
    double[] frame = frame(model, link);
    double x = point.x() - frame[9];
    double y = point.y() - frame[10];
    double z = point.z() - frame[11];
    Vector3 inLink =
        new Vector3(
            frame[0] * x + frame[3] * y + frame[6] * z,
            frame[1] * x + frame[4] * y + frame[7] * z,
            frame[2] * x + frame[5] * y + frame[8] * z);
    return Optional.of(new HeldPoint(link, inLink, point, camera.ray(1, 1, 2, 2).direction()));
  }

  /** The joint that moves a body; the base has none. */
  private static OptionalInt joint(Link link) {
    return switch (link) {
      case BASE -> OptionalInt.empty();
      case SHOULDER -> OptionalInt.of(0);
      case UPPER_ARM -> OptionalInt.of(1);
      case FOREARM -> OptionalInt.of(2);
      case WRIST_1 -> OptionalInt.of(3);
      case WRIST_2 -> OptionalInt.of(4);
      case WRIST_3 -> OptionalInt.of(5);
    };
  }

  private static double[] frame(SceneModel model, int link) {
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    model.kinematics().frames(model.positionRad().toArray(), frames);
    return frames[link];
  }

  /** Where the point is now, in the base frame, m. */
  Vector3 inBaseM(SceneModel model) {
    double[] f = frame(model, link);
    return new Vector3(
        f[9] + f[0] * inLinkM.x() + f[1] * inLinkM.y() + f[2] * inLinkM.z(),
        f[10] + f[3] * inLinkM.x() + f[4] * inLinkM.y() + f[5] * inLinkM.z(),
        f[11] + f[6] * inLinkM.x() + f[7] * inLinkM.y() + f[8] * inLinkM.z());
  }

  /** Where a ray meets the plane; empty if it does not in front of the eye, or at a flat angle. */
  Optional<Vector3> placeM(Ray ray) {
    return new DragPlane(grabbedInBaseM, towardsScene).meet(ray);
  }
}
