package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

class HandGripTest {
  private static final Vector3 ORIGIN = new Vector3(0, 0, 0);

  private final HandGrip grip = new HandGrip();

  private double[] force(double x, double y, double z, double speed) {
    double[] force = new double[3];
    grip.force(new double[] {x, y, z}, new double[] {speed, 0, 0}, force);
    return force;
  }

  private void frames(int count) {
    for (int i = 0; i < count; i++) {
      grip.beginFrame();
    }
  }

  @Test
  void aPushIsTheSameEverywhereUntilToldOtherwise() {
    grip.push(3, ORIGIN, new Vector3(1, 2, 3));
    frames(100_000);
    assertTrue(grip.holds());
    assertFalse(grip.pulls());
    assertEquals(3, grip.link());
    assertArrayEquals(new double[] {1, 2, 3}, force(5, 5, 5, 9));
    grip.push(3, ORIGIN, ORIGIN);
    assertFalse(grip.holds());
  }

  @Test
  void aPullIsASpringWithADamper() {
    grip.pull(5, ORIGIN, new Vector3(0.05, 0, 0));
    assertArrayEquals(new double[] {50, 0, 0}, force(0, 0, 0, 0), 1e-9);
    assertArrayEquals(new double[] {30, 0, 0}, force(0, 0, 0, 0.5), 1e-9);
    assertArrayEquals(new double[] {0, 0, 0}, force(0.05, 0, 0, 0), 1e-9);
  }

  @Test
  void aPullIsBoundedInItsDirection() {
    grip.pull(5, ORIGIN, new Vector3(30, 40, 0));
    assertArrayEquals(new double[] {60, 80, 0}, force(0, 0, 0, 0), 1e-9);
  }

  @Test
  void thePlaceIsFollowedSmoothly() {
    grip.pull(5, ORIGIN, ORIGIN);
    grip.pull(5, ORIGIN, new Vector3(0.05, 0, 0));
    double last = force(0, 0, 0, 0)[0];
    assertEquals(0, last);
    for (int frame = 0; frame < 100; frame++) {
      grip.beginFrame();
      double now = force(0, 0, 0, 0)[0];
      assertTrue(now > last && now - last < 3, "from " + last + " to " + now + " N");
      last = now;
    }
    assertEquals(50, last, 1);
  }

  @Test
  void aPullThatIsNotRepeatedLetsGo() {
    grip.pull(5, ORIGIN, ORIGIN);
    frames(125);
    assertTrue(grip.holds());
    grip.pull(5, ORIGIN, ORIGIN);
    frames(125);
    assertTrue(grip.holds());
    frames(1);
    assertFalse(grip.holds());
  }

  @Test
  void whoLooksOnlyAtChangesMissesNone() {
    long before = grip.changes();
    grip.pull(5, ORIGIN, ORIGIN);
    assertTrue(grip.changes() > before);
    before = grip.changes();
    frames(10);
    assertEquals(before, grip.changes(), "the place is reached");
    grip.pull(5, ORIGIN, new Vector3(0.1, 0, 0));
    before = grip.changes();
    frames(1);
    assertTrue(grip.changes() > before, "the place moves");
    before = grip.changes();
    grip.letGo();
    assertTrue(grip.changes() > before);
  }

  @Test
  void refusesLinksPointsAndForcesThatThereAreNot() {
    refused("link is 6, must be 0 to 5", () -> grip.push(6, ORIGIN, new Vector3(1, 0, 0)));
    refused("point[1] is 5 m, must be -4 to 4 m", () -> grip.pull(0, new Vector3(0, 5, 0), ORIGIN));
    refused("force[2] is NaN", () -> grip.push(0, ORIGIN, new Vector3(0, 0, Double.NaN)));
    refused("place[0] is 101 m", () -> grip.pull(0, ORIGIN, new Vector3(101, 0, 0)));
    assertFalse(grip.holds());
  }

  private static void refused(String part, Executable call) {
    String message = assertThrows(IllegalArgumentException.class, call).getMessage();
    assertTrue(message.contains(part), message);
  }
}
