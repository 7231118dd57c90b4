package org.pendant.controller.installation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

class FeaturePosesTest {
  private static Optional<Pose> pose(FeatureKind kind, Pose... points) {
    return FeaturePoses.pose(new Feature("f", kind, List.of(points), false, false));
  }

  private static Pose at(double x, double y, double z) {
    return new Pose(x, y, z, 0, 0, 0);
  }

  private static void assertNear(Pose expected, Pose actual) {
    assertTrue(
        Poses.pointDistance(expected, actual) < 1e-9
            && Poses.rotationAngle(expected, actual) < 1e-9,
        () -> "expected " + expected + " but was " + actual);
  }

  @Test
  void aPointIsItsOwnFrame() {
    Pose taught = new Pose(1, 2, 3, 0.1, 0.2, 0.3);
    assertEquals(Optional.of(taught), pose(FeatureKind.POINT, taught));
  }

  @Test
  void aLineHasYTowardsItsSecondPoint() {
    assertNear(at(1, 0, 0), pose(FeatureKind.LINE, at(1, 0, 0), at(1, 5, 0)).orElseThrow());
    Pose alongX = pose(FeatureKind.LINE, at(0, 0, 0), at(2, 0, 0)).orElseThrow();
    assertNear(new Pose(0, 0, 0, 0, 0, -Math.PI / 2), alongX);
  }

  @Test
  void aLineAlongTheToolStillHasAFrame() {
    Pose up = pose(FeatureKind.LINE, at(0, 0, 0), at(0, 0, 1)).orElseThrow();
    assertNear(at(0, 0, 3), Poses.trans(up, at(0, 3, 0)).with(3, 0).with(4, 0).with(5, 0));
  }

  @Test
  void aPlaneHasXTowardsItsSecondPointAndPositiveYAtItsThird() {
    Random random = new Random(7);
    for (int i = 0; i < 1000; i++) {
      Pose frame =
          new Pose(
              random.nextGaussian(),
              random.nextGaussian(),
              random.nextGaussian(),
              random.nextGaussian(),
              random.nextGaussian(),
              random.nextGaussian());
      Pose onX = Poses.trans(frame, at(0.1 + random.nextDouble(), 0, 0));
      Pose beside = Poses.trans(frame, at(random.nextGaussian(), 0.1 + random.nextDouble(), 0));
      assertNear(frame, pose(FeatureKind.PLANE, frame, onX, beside).orElseThrow());
    }
  }

  @Test
  void thereIsNoneForTooFewOrCollapsedPoints() {
    Optional<Pose> none = Optional.empty();
    assertEquals(none, pose(FeatureKind.POINT));
    assertEquals(none, pose(FeatureKind.LINE, at(0, 0, 0)));
    assertEquals(none, pose(FeatureKind.LINE, at(1, 1, 1), at(1, 1, 1)));
    assertEquals(none, pose(FeatureKind.PLANE, at(0, 0, 0), at(1, 0, 0), at(3, 0, 0)));
    assertEquals(none, pose(FeatureKind.PLANE, at(0, 0, 0), at(1, 0, 0), at(0, 0, 0)));
    assertEquals(none, pose(FeatureKind.POINT, at(Double.NaN, 0, 0)));
  }
}
