package org.pendant.desktop.scene.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

final class ProfileTest {

  @Test
  void aSharpCornerIsThereWithTheNormalsOfBothSides() {
    List<Profile.Point> points =
        new Profile().to(0, 0).to(1, 0).to(1, 2).to(0, 2).points(Detail.FINE);

    assertEquals(
        List.of(
            new Profile.Point(0, 0, 0, -1),
            new Profile.Point(1, 0, 0, -1),
            new Profile.Point(1, 0, 1, 0),
            new Profile.Point(1, 2, 1, 0),
            new Profile.Point(1, 2, 0, 1),
            new Profile.Point(0, 2, 0, 1)),
        points.stream().map(ProfileTest::rounded).toList());
  }

  @Test
  void aRoundedCornerKeepsItsRadiusFromItsCentre() {
    List<Profile.Point> points =
        new Profile().to(0, 0).to(1, 0, 0.25).to(1, 2).to(0, 2).points(Detail.FINE);

    for (Profile.Point point : points.subList(1, 4)) {
      assertEquals(0.25, Math.hypot(point.r() - 0.75, point.z() - 0.25), 1e-12);
    }
  }

  @Test
  void aHollowCornerIsRoundedOnTheOutside() {
    List<Profile.Point> points =
        new Profile()
            .to(0, 0)
            .to(2, 0)
            .to(2, 1)
            .to(1, 1, 0.2)
            .to(1, 2)
            .to(0, 2)
            .points(Detail.FINE);

    List<Profile.Point> hollow =
        points.stream().filter(p -> p.r() > 1.001 && p.r() < 1.199 && p.z() > 1.001).toList();
    assertTrue(!hollow.isEmpty());
    for (Profile.Point point : hollow) {
      assertEquals(0.2, Math.hypot(point.r() - 1.2, point.z() - 1.2), 1e-12);
      assertTrue(point.nr() > 0 && point.nz() > 0);
    }
  }

  @Test
  void aRoundingThatDoesNotFitIsMadeSmaller() {
    List<Profile.Point> points =
        new Profile().to(0, 0).to(1, 0, 50).to(1, 0.1).to(0, 0.1).points(Detail.FINE);

    assertTrue(points.stream().allMatch(p -> p.r() <= 1 + 1e-12 && p.z() <= 0.1 + 1e-12));
  }

  private static Profile.Point rounded(Profile.Point p) {
    return new Profile.Point(round(p.r()), round(p.z()), round(p.nr()), round(p.nz()));
  }

  private static double round(double x) {
    return Math.rint(1e9 * x) / 1e9 + 0.0;
  }
}
