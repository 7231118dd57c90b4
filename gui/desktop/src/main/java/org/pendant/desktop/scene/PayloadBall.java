package org.pendant.desktop.scene;

import java.util.Optional;
import org.pendant.controller.world.Vector3;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Payload ball: shows a payload as a ball of plastic that is as heavy, around its centre of
 * gravity.
 */
public final class PayloadBall {
  private static final double DENSITY_KG_PER_M3 = 1200;

  private PayloadBall() {}

  /** The ball in the base frame; none for a payload without mass. */
  public static Optional<Ball> of(Payload payload, Pose flangeInBase) {
    if (payload.massKg() <= 0) {
      return Optional.empty();
    }
    double radiusM = Math.cbrt(payload.massKg() / DENSITY_KG_PER_M3 * 3 / (4 * Math.PI));
    double[] t = new double[Transforms.SIZE];
    Transforms.of(flangeInBase, t);
    double x = payload.cogXM();
    double y = payload.cogYM();
    double z = payload.cogZM();
    Vector3 centre =
        new Vector3(
            t[9] + t[0] * x + t[1] * y + t[2] * z,
            t[10] + t[3] * x + t[4] * y + t[5] * z,
            t[11] + t[6] * x + t[7] * y + t[8] * z);
    return Optional.of(new Ball(centre, radiusM));
  }
}
