package org.pendant.desktop.scene.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.models.pose.Pose;

final class LinesTest {
  private static final SceneObject BOX =
      new SceneObject.Box(
          "box",
          new Pose(1, 0, 0, 0, 0, Math.PI / 2),
          new Vector3(0.4, 0.2, 0.6),
          Material.DEFAULT);
  private static final SceneObject BALL =
      new SceneObject.Sphere("ball", new Vector3(0, 0, 0), 0.1, Material.DEFAULT);

  private static double length(Lines lines, int from) {
    double square = 0;
    for (int k = 0; k < 3; k++) {
      square += Math.pow(lines.number(from + 1, k) - lines.number(from, k), 2);
    }
    return Math.sqrt(square);
  }

  @Test
  void aPointKnowsItsPlaceAndColour() {
    Lines lines = new Lines().from(1, 2, 3, 0xFF8000, 0.5).to(4, 5, 6, 0, 1);

    assertEquals(2, lines.size());
    assertEquals(3, lines.number(0, 2));
    assertEquals(1, lines.number(0, 3));
    assertEquals(1, lines.number(0, 4));
    assertEquals(0.5, lines.number(0, 7));
    assertEquals(0, lines.number(1, 3));
    assertEquals(2 * Lines.STRIDE, lines.numbers().length);
  }

  @Test
  void aBoxHasTwelveEdgesWhereItStands() {
    Lines lines = BoxEdges.of(List.of(BOX, BALL), Set.of(), 1, 2);

    assertEquals(24, lines.size());
    double sum = 0;
    for (int i = 0; i < lines.size(); i += 2) {
      sum += length(lines, i);
      assertEquals(0.1, Math.abs(lines.number(i, 0) - 1), 1e-6);
    }
    assertEquals(4 * (0.4 + 0.2 + 0.6), sum, 1e-5);
  }

  @Test
  void theEdgesOfWhatIsTouchedLookDifferent() {
    float plain = BoxEdges.of(List.of(BOX), Set.of("ball"), 1, 200).number(0, 6);
    float touched = BoxEdges.of(List.of(BOX), Set.of("box"), 1, 200).number(0, 6);

    assertNotEquals(plain, touched);
  }

  @Test
  void metresAreWrittenOnTheFloorAlongBothAxes() {
    Lines none = FloorScale.of(FloorGrid.METRES, 0.4, 0, 0, 0, 0);
    Lines one = FloorScale.of(FloorGrid.METRES, 0.9, -0.2, 0, 0, 0);
    Lines two = FloorScale.of(FloorGrid.METRES, 1.1, -0.2, 0, 0, 0);

    assertEquals(0, none.size());
    assertTrue(one.size() > 0);
    assertTrue(two.size() > one.size());
    for (int i = 0; i < two.size(); i++) {
      assertEquals(-0.2f, two.number(i, 2));
      assertTrue(Math.hypot(two.number(i, 0), two.number(i, 1)) < 1.4);
    }
  }

  @Test
  void peopleWhoReadInchesFindRoundNumbersOfThemOnTheFloor() {
    assertEquals("0.5 m", FloorGrid.of(DisplayUnit.MILLIMETRE).text(1));
    assertEquals("1 m", FloorGrid.of(DisplayUnit.METRE).text(2));
    assertEquals("20 in", FloorGrid.of(DisplayUnit.INCH).text(1));
    for (FloorGrid each : FloorGrid.values()) {
      assertEquals(0, FloorScale.of(each, each.strongM() - 1e-3, 0, 0, 0, 0).size());
      Lines one = FloorScale.of(each, each.strongM(), 0, 0, 0, 0);
      assertTrue(one.size() > 0);
      for (int i = 0; i < one.size(); i++) {
        double farM = Math.hypot(one.number(i, 0), one.number(i, 1));
        assertEquals(each.strongM(), farM, 0.3, "beside its line");
      }
    }
  }

  @Test
  void theWritingTurnsWithTheEye() {
    assertEquals(0, FloorScale.quarters(Math.toRadians(-90)));
    assertEquals(0, FloorScale.quarters(Math.toRadians(-52)));
    assertEquals(1, FloorScale.quarters(0));
    assertEquals(2, FloorScale.quarters(Math.toRadians(90)));
    assertEquals(3, FloorScale.quarters(Math.toRadians(180)));
    Optional<Float> first =
        Optional.of(FloorScale.of(FloorGrid.METRES, 0.6, 0, 0, 0, 0).number(0, 0));
    assertNotEquals(
        first, Optional.of(FloorScale.of(FloorGrid.METRES, 0.6, 0, 2, 0, 0).number(0, 0)));
  }
}
