package org.pendant.desktop.move;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/** URScript text, aligned tools and drawn ranges. */
final class MoveTextTest {

  @Test
  void positionsAreWrittenAsScript() {
    assertEquals(
        "[0, -1.570796, 0.5, 100, 0, -0.000002]",
        PositionText.of(new Joints(0, -Math.PI / 2, 0.5, 100, -1e-9, -2e-6)));
    assertEquals(
        "p[0.1, -0.25, 0, 0, 3.141593, 0]",
        PositionText.of(new Pose(0.1, -0.25, 0, 0, Math.PI, 0)));
  }

  @Test
  void aTiltedToolIsTurnedToTheNearestAxis() {
    Pose down = new Pose(0.4, 0.1, 0.3, Math.PI, 0, 0);
    Pose tilted = Poses.add(new Pose(0, 0, 0, 0.2, 0.1, 0), down);
    Pose aligned = ToolAlignment.nearest(tilted);
    assertEquals(0, Poses.pointDistance(tilted, aligned), 1e-15);
    Pose z = Poses.sub(Poses.trans(aligned, new Pose(0, 0, 1, 0, 0, 0)), aligned);
    assertEquals(-1, z.z(), 1e-12);
  }

  @Test
  void alignmentTurnsByNoMoreThanItMust() {
    SplittableRandom random = new SplittableRandom(3);
    for (int i = 0; i < 1000; i++) {
      Pose pose = Pose.of(random.doubles(6, -1.7, 1.7).toArray());
      Pose aligned = ToolAlignment.nearest(pose);
      Pose z = Poses.sub(Poses.trans(aligned, new Pose(0, 0, 1, 0, 0, 0)), aligned);
      double largest = Math.max(Math.abs(z.x()), Math.max(Math.abs(z.y()), Math.abs(z.z())));
      assertEquals(1, largest, 1e-9, () -> "of " + pose);
      // no direction is farther from every axis than the diagonal
      double farthest = Math.acos(1 / Math.sqrt(3));
      assertTrue(Poses.rotationAngle(pose, aligned) <= farthest + 1e-9, () -> "of " + pose);
      assertEquals(0, Poses.distance(aligned, ToolAlignment.nearest(aligned)), 1e-7);
    }
  }

  @Test
  void aJointIsDrawnWithinItsRange() {
    JointRange range = JointRange.of(new JointLimits(-9, 9, 1, 1), -2, 2);
    assertEquals(0.75, range.share(1));
    assertEquals(1, range.share(5));
    assertFalse(range.contains(2.1));
  }

  @Test
  void aJointThatTurnsWithoutEndIsDrawnWithinATurnEitherWay() {
    JointRange range =
        JointRange.of(
            new JointLimits(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, 1, 1),
            Double.NEGATIVE_INFINITY,
            Double.POSITIVE_INFINITY);
    assertTrue(range.contains(1000));
    assertEquals(range.share(1), range.share(1 + 4 * Math.PI), 1e-12);
  }

  @Test
  void reasonsAreSentencesThatNameTheJoints() {
    assertEquals(
        "Elbow is at the end of its range.",
        JointNames.sentence("joint 2 is at the end of its range"));
    assertEquals(
        "Too fast: wrist 3 would turn at 9 rad/s.",
        JointNames.sentence("too fast: joint 5 would turn at 9 rad/s"));
    assertEquals("", JointNames.sentence(""));
  }
}
