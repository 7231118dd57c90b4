package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.world.Material;
import org.pendant.models.pose.Pose;

/** Force mode with an arm that has mass and a table to press on. */
final class ForceModeContactTest {
  /** Presses down with 20 N. */
  private static final String PRESS =
      "force_mode(p[0, 0, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, -20, 0, 0, 0], 2,"
          + " [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])\n";

  @ParameterizedTest
  @CsvSource({
    "ur5e, 1000", "ur5e, 10000", "ur5e, 40000", "ur5e, 200000", "ur3e, 10000", "ur3e, 100000",
    "ur10e, 40000", "ur16e, 40000", "ur20, 1000", "ur20, 40000", "ur30, 200000"
  })
  void theForceIsRightWithinTwoPercentAfterASecond(String robot, double stiffnessNPerM) {
    PressingArm pressing =
        PressingArm.overTable(robot, 0.01, new Material(stiffnessNPerM, 0.2, 0.3));
    pressing.start(PRESS + "sleep(10)\n");
    pressing.untilContact();
    pressing.frames(500);
    double[] sum = new double[1];
    pressing.frames(500, () -> sum[0] += pressing.pressN());
    assertEquals(20, sum[0] / 500, 0.4);
    assertEquals(SafetyMode.NORMAL, pressing.running.state().safety().safetyMode());
  }

  @Test
  void onTheUsualTableItIsRightInEveryFrame() {
    PressingArm pressing = PressingArm.overTable(0.01);
    pressing.start(PRESS + "sleep(10)\n");
    pressing.untilContact();
    pressing.frames(500);
    pressing.frames(1000, () -> assertEquals(20, pressing.pressN(), 0.4));
  }

  @Test
  void theToolPressesWhileAMoveSlidesIt() {
    PressingArm pressing = PressingArm.overTable(0.01);
    pressing.start(
        "here = get_target_tcp_pose()\n"
            + PRESS
            + """
            sleep(1.5)
            movel(pose_trans(p[0, 0.1, 0, 0, 0, 0], here), a=0.5, v=0.1)
            textmsg("there")
            sleep(1)
            """);
    pressing.frames(740);
    Pose before = pressing.target();
    List<Double> forces = new ArrayList<>();
    pressing.frames(700, () -> forces.add(pressing.pressN()));
    Pose after = pressing.target();
    assertEquals(0.1, after.y() - before.y(), 1e-9);
    assertEquals(0, after.x() - before.x(), 1e-9);
    assertEquals(List.of("there"), pressing.running.said());
    assertTrue(forces.stream().allMatch(n -> n > 15 && n < 25), forces::toString);
    double mean = forces.stream().mapToDouble(n -> n).average().orElseThrow();
    assertEquals(20, mean, 0.4);
  }

  @Test
  void endingItKeepsTheToolWhereItIs() {
    PressingArm pressing = PressingArm.overTable(0.01);
    pressing.start(PRESS + "sleep(2)\nend_force_mode()\nsleep(1)\nstopl(1)\ntextmsg(\"on\")\n");
    pressing.frames(1000);
    Pose before = pressing.target();
    pressing.frames(600);
    Pose after = pressing.target();
    assertEquals(before.z(), after.z(), 2e-5);
    assertEquals(20, pressing.pressN(), 1);
    assertEquals(List.of("on"), pressing.running.said());
  }

  @Test
  void aSmallArmMayPressHarderThanACollisionIs() {
    PressingArm pressing =
        PressingArm.overTable("ur3e", 0.01, new Material(1e4, 0.2, 0.3));
    pressing.start(PRESS.replace("-20", "-40") + "sleep(10)\n");
    pressing.frames(1500);
    assertEquals(SafetyMode.NORMAL, pressing.running.state().safety().safetyMode());
    assertEquals(40, pressing.pressN(), 0.8);
  }
}
