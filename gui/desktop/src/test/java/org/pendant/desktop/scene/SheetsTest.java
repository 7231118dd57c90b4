package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.SafetySight.State;
import org.pendant.desktop.scene.mesh.Lines;

final class SheetsTest {
  private static final Vector3 EYE = new Vector3(0, -3, 0.5);

  private static SafetySight.Plane wall(double y, State state) {
    return new SafetySight.Plane(
        new SafetyPlane("wall " + y, 0, y, 0, new Axis(0, -1, 0), Applies.BOTH, false), state);
  }

  private static SceneModel with(SafetySight.Plane... planes) {
    return Models.of("ur5e")
        .withSafety(new SafetySight(List.of(planes), List.of(), List.of(), false));
  }

  private static List<Sheets.Sheet> sheets(SceneModel model) {
    return Sheets.of(model, Ground.of(model), EYE);
  }

  @Test
  void whatIsFartherAwayIsDrawnFirst() {
    List<Sheets.Sheet> sheets =
        sheets(with(wall(-0.5, State.HOLDS), wall(0.9, State.HOLDS), wall(0.4, State.HOLDS)));

    assertEquals(
        List.of(0.9f, 0.4f, -0.5f),
        sheets.stream().map(each -> each.frame().getTranslation(new Vector3f()).y).toList());
  }

  @Test
  void aSheetBehindTheArmIsToldFromOneInFrontOfIt() {
    List<Sheets.Sheet> sheets = sheets(with(wall(-0.5, State.HOLDS), wall(0.5, State.HOLDS)));

    assertTrue(sheets.getFirst().behind());
    assertFalse(sheets.getLast().behind());
  }

  @Test
  void arrowsLeadToTheAllowedSide() {
    Lines lines = SafetyOutlines.of(with(wall(0.5, State.HOLDS)));

    List<Float> away = new ArrayList<>();
    for (int i = 0; i < lines.size(); i++) {
      away.add(lines.number(i, 1));
    }
    assertTrue(away.stream().allMatch(y -> y < 0.5f + 1e-5f), away.toString());
    assertTrue(away.stream().anyMatch(y -> y < 0.45f), away.toString());
  }

  @Test
  void aPlaneForTheElbowHasASecondOutlineAndATypedOneBrokenLines() {
    SafetyPlane tool = new SafetyPlane("a", 0, 0, 0, new Axis(0, 0, 1), Applies.BOTH, false);
    SafetyPlane elbow = new SafetyPlane("a", 0, 0, 0, new Axis(0, 0, 1), Applies.BOTH, true);
    int usual = SafetyOutlines.of(with(new SafetySight.Plane(tool, State.HOLDS))).size();

    assertEquals(
        usual + 8, SafetyOutlines.of(with(new SafetySight.Plane(elbow, State.HOLDS))).size());
    assertTrue(
        SafetyOutlines.of(with(new SafetySight.Plane(tool, State.PROPOSED))).size() > usual + 20);
  }

  @Test
  void nothingIsDrawnOfNothing() {
    assertEquals(0, SafetyOutlines.of(Models.of("ur5e")).size());
  }

  @Test
  void theOutlineOfTheReachIsAsFarFromTheShoulderAsTheArmReaches() {
    SceneModel model =
        Models.of("ur5e").withSafety(new SafetySight(List.of(), List.of(), List.of(), true));
    double shoulderM = model.arm().dh().d1();
    Lines lines = SafetyOutlines.of(model);

    for (int i = 0; i < lines.size(); i++) {
      double distanceM =
          Math.hypot(
              Math.hypot(lines.number(i, 0), lines.number(i, 1)), lines.number(i, 2) - shoulderM);
      assertEquals(model.arm().reachM(), distanceM, 1e-5);
    }
  }
}
