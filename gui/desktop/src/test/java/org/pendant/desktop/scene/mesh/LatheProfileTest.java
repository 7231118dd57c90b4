package org.pendant.desktop.scene.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

final class LatheProfileTest {

  @Test
  void aSharpCornerIsThereWithTheNormalsOfBothSides() {
    List<LatheProfile.Point> points =
        new LatheProfile().to(0, 0).to(1, 0).to(1, 2).to(0, 2).points(Detail.FINE);

    assertEquals(
        List.of(
            new LatheProfile.Point(0, 0, 0, -1),
            new LatheProfile.Point(1, 0, 0, -1),
            new LatheProfile.Point(1, 0, 1, 0),
            new LatheProfile.Point(1, 2, 1, 0),
            new LatheProfile.Point(1, 2, 0, 1),
            new LatheProfile.Point(0, 2, 0, 1)),
        points.stream().map(LatheProfileTest::rounded).toList());
  }

  @Test
  void aRoundedCornerKeepsItsRadiusFromItsCentre() {
    List<LatheProfile.Point> points =
        new LatheProfile().to(0, 0).to(1, 0, 0.25).to(1, 2).to(0, 2).points(Detail.FINE);

    for (LatheProfile.Point point : points.subList(1, 4)) {
      assertEquals(0.25, Math.hypot(point.r() - 0.75, point.z() - 0.25), 1e-12);
    }
  }

  @Test
  void aHollowCornerIsRoundedOnTheOutside() {
    List<LatheProfile.Point> points =
        new LatheProfile()
            .to(0, 0)
            .to(2, 0)
            .to(2, 1)
            .to(1, 1, 0.2)
            .to(1, 2)
            .to(0, 2)
            .points(Detail.FINE);

    List<LatheProfile.Point> hollow =
        points.stream().filter(p -> p.r() > 1.001 && p.r() < 1.199 && p.z() > 1.001).toList();
    assertTrue(!hollow.isEmpty());
    for (LatheProfile.Point point : hollow) {
      assertEquals(0.2, Math.hypot(point.r() - 1.2, point.z() - 1.2), 1e-12);
      assertTrue(point.nr() > 0 && point.nz() > 0);
    }
  }

  @Test
  void aRoundingThatDoesNotFitIsMadeSmaller() {
    List<LatheProfile.Point> points =
        new LatheProfile().to(0, 0).to(1, 0, 50).to(1, 0.1).to(0, 0.1).points(Detail.FINE);

    assertTrue(points.stream().allMatch(p -> p.r() <= 1 + 1e-12 && p.z() <= 0.1 + 1e-12));
  }

  private static LatheProfile.Point rounded(LatheProfile.Point p) {
    return new LatheProfile.Point(round(p.r()), round(p.z()), round(p.nr()), round(p.nz()));
  }

  private static double round(double x) {
    return Math.rint(1e9 * x) / 1e9 + 0.0;
  }
}
