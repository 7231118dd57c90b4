package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.pose;

import org.junit.jupiter.api.Test;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;

class PoseBuiltinsTest {
  private static final PoseValue FIRST = pose(.2, .5, .1, 1.57, 0, 0);
  private static final PoseValue SECOND = pose(.2, .5, .6, 1.57, 0, 0);
  private static final PoseValue TURNED = pose(.2, .5, .1, 1.57, 0, 3.14);
  private static final PoseValue ASIDE = pose(.2, .5, .6, 0, 1.57, 3.14);

  private final CallFixture fixture = new CallFixture();

  private void answersPose(double[] expected, double tolerance, String name, Object... arguments)
      throws ScriptError {
    PoseValue found = (PoseValue) fixture.call(name, arguments);
    assertArrayEquals(expected, found.pose().toArray(), tolerance, found.text());
  }

  private double number(String name, Object... arguments) throws ScriptError {
    return ((FloatValue) fixture.call(name, arguments)).value();
  }

  @Test
  void posesAreInterpolatedAlongALine() throws ScriptError {
    PoseValue low = pose(.2, .2, .4, 0, 0, 0);
    PoseValue high = pose(.2, .2, .6, 0, 0, 0);
    answersPose(new double[] {.2, .2, .5, 0, 0, 0}, 1e-12, "interpolate_pose", low, high, .5);
    answersPose(new double[] {.2, .2, .4, 0, 0, 0}, 0, "interpolate_pose", low, high, 0);
    answersPose(new double[] {.2, .2, .6, 0, 0, 0}, 0, "interpolate_pose", low, high, 1);
    answersPose(new double[] {.2, .2, .7, 0, 0, 0}, 1e-12, "interpolate_pose", low, high, 1.5);
    answersPose(new double[] {.2, .2, .2, 0, 0, 0}, 1e-12, "interpolate_pose", low, high, -1);
  }

  @Test
  void distancesCountPositionAndPartlyRotation() throws ScriptError {
    assertEquals(0.5, number("point_dist", TURNED, ASIDE), 1e-12);
    double angle = 4 * number("pose_dist", pose(0, 0, 0, 0, 0, 0), pose(0.1, 0, 0, 0, 0, 2));
    assertEquals(2.0, angle, 1e-12);
    assertEquals(0.5, number("pose_dist", FIRST, SECOND), 1e-12);
  }

  @Test
  void posesAddAndSubtractPartByPart() throws ScriptError {
    answersPose(new double[] {.4, 1, .7, 3.14, 0, 0}, 1e-12, "pose_add", FIRST, SECOND);
    answersPose(new double[] {0, 0, -.5, 0, 0, 0}, 1e-12, "pose_sub", FIRST, SECOND);
  }

  @Test
  void posesTransformAndInvert() throws ScriptError {
    answersPose(new double[] {.4, -.0996, .60048, 3.14, 0, 0}, 1e-5, "pose_trans", FIRST, SECOND);
    double[] inverse = {.19324, .41794, -.29662, 1.23993, 0, 2.47985};
    answersPose(inverse, 1e-5, "pose_inv", TURNED);
    answersPose(inverse, 1e-5, "inv", TURNED);
  }

  @Test
  void listsAreNoPoses() {
    refuses(
        "wrong-type",
        "pose_trans: p_from_to is list [0, 0, 0, 0, 0, 0], must be a pose",
        () -> fixture.call("pose_trans", FIRST, floats(0, 0, 0, 0, 0, 0)));
    refuses("wrong-type", "p_from", () -> fixture.call("pose_inv", 1));
    refuses("wrong-type", "alpha", () -> fixture.call("interpolate_pose", FIRST, SECOND, "x"));
  }
}
