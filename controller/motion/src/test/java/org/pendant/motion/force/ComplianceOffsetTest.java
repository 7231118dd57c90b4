package org.pendant.motion.force;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Collections;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

final class ComplianceOffsetTest {
  private final ComplianceOffset complianceOffset = new ComplianceOffset();
  private final SplittableRandom random = new SplittableRandom(3);

  private double[] transform() {
    double[] n = random.doubles(6, -1, 1).toArray();
    double[] transform = new double[Transforms.SIZE];
    Transforms.of(new Pose(n[0], n[1], n[2], n[3], n[4], n[5]), transform);
    return transform;
  }

  private void wander() {
    for (int i = 0; i < 500; i++) {
      complianceOffset.advance(random.doubles(6, -1, 1).toArray());
    }
  }

  @Test
  void anEvenVelocityAddsUp() {
    for (int i = 0; i < 500; i++) {
      complianceOffset.advance(new double[] {0.1, 0, -0.2, 0, 0, 0.5});
    }
    double[] tcp = new double[Transforms.SIZE];
    Transforms.of(new Pose(1, 1, 1, 0, 0, 0), tcp);
    complianceOffset.apply(tcp);
    assertEquals(1.1, tcp[9], 1e-12);
    assertEquals(1, tcp[10], 1e-12);
    assertEquals(0.8, tcp[11], 1e-12);
    assertEquals(Math.cos(0.5), tcp[0], 1e-6);
    assertEquals(Math.sin(0.5), tcp[3], 1e-6);
  }

  @Test
  void undoneItIsAsItWas() {
    wander();
    double[] path = transform();
    double[] before = path.clone();
    complianceOffset.apply(before);
    complianceOffset.advance(new double[] {1, 2, 3, 4, 5, 6});
    double[] now = path.clone();
    complianceOffset.apply(now);
    complianceOffset.undo(now, 0);
    complianceOffset.undo(before, 1);
    assertArrayEquals(path, now, 1e-12);
    assertArrayEquals(path, before, 1e-12);
  }

  @Test
  void anotherPointOfTheToolLeavesTheToolWhereItIs() {
    wander();
    double[] one = transform();
    double[] offset = transform();
    double[] other = new double[Transforms.SIZE];
    Transforms.multiply(one, offset, other);
    double[] carriedOne = one.clone();
    complianceOffset.apply(carriedOne);
    double[] expected = new double[Transforms.SIZE];
    Transforms.multiply(carriedOne, offset, expected);
    complianceOffset.movePoint(other[9] - one[9], other[10] - one[10], other[11] - one[11]);
    complianceOffset.apply(other);
    assertArrayEquals(expected, other, 1e-12);
  }

  @Test
  void theDeviationIsAlongTheAxesOfTheTask() {
    complianceOffset.advance(new double[] {50, 0, 0, 0, 0, 0.5});
    TaskAxes axes = new TaskAxes();
    axes.begin(
        new ForceTask(
            FrameKind.FIXED,
            new Pose(0, 0, 0, 0, 0, Math.PI / 2),
            Collections.nCopies(6, new ForceAxis(false, 0, 1))));
    double[] deviation = new double[6];
    complianceOffset.measure(axes, deviation);
    assertArrayEquals(new double[] {0, -0.1, 0, 0, 0, 1e-3}, deviation, 1e-9);
  }
}
