package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;

final class LinkPlacesTest {
  private static final ArmDescription ARM = ArmLibrary.load("ur5e");

  private static LinkPlaces places(Joints q) {
    return new LinkPlaces(new ForwardKinematics(ARM), ARM.dh(), q);
  }

  private static Vector3f point(LinkPlaces places, Link link, double x, double y, double z) {
    return places.of(link).transformPosition(new Vector3f((float) x, (float) y, (float) z));
  }

  private static Joints random(Random random) {
    double[] q = random.doubles(Joints.COUNT, -3, 3).toArray();
    return Joints.of(q);
  }

  @Test
  void theLastBodyIsTheFlange() {
    Joints q = random(new Random(1));
    Pose flange = new ForwardKinematics(ARM).flangePose(q);

    Vector3f origin = point(places(q), Link.WRIST_3, 0, 0, 0);

    assertEquals(flange.x(), origin.x, 1e-6);
    assertEquals(flange.y(), origin.y, 1e-6);
    assertEquals(flange.z(), origin.z, 1e-6);
  }

  @Test
  void everyBodyTurnsOnTheAxisOfTheOneBefore() {
    DhLengths dh = ARM.dh();
    Random random = new Random(2);
    for (int i = 0; i < 100; i++) {
      LinkPlaces places = places(random(random));
      Vector3f shoulder = point(places, Link.SHOULDER, 0, -0.1, 0);
      assertNear(shoulder, point(places, Link.UPPER_ARM, 0, 0, 0.1));
      assertNear(
          point(places, Link.UPPER_ARM, dh.a2(), 0, 0.1), point(places, Link.FOREARM, 0, 0, 0.1));
      assertNear(
          point(places, Link.FOREARM, dh.a3(), 0, 0.1),
          point(places, Link.WRIST_1, 0, 0, 0.1 - dh.d4()));
      assertNear(
          point(places, Link.WRIST_1, 0, -0.1, 0),
          point(places, Link.WRIST_2, 0, 0, 0.1 - dh.d5()));
      assertNear(
          point(places, Link.WRIST_2, 0, 0.1, 0), point(places, Link.WRIST_3, 0, 0, 0.1 - dh.d6()));
    }
  }

  @Test
  void theBaseStaysWhereItIs() {
    assertNear(new Vector3f(1, 2, 3), point(places(Models.WORKING), Link.BASE, 1, 2, 3));
  }

  private static void assertNear(Vector3f expected, Vector3f found) {
    assertTrue(expected.distance(found) < 1e-5, found + " must be " + expected);
  }
}
