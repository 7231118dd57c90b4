package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.ToolPoint;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.pose.Wrench;

class WeightOnToolTest {
  /** Forearm level, tool up. */
  private static final Joints UP =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, Math.PI / 2, 0);

  @Test
  void aBoxThatRestsOnTheToolIsFeltByFlangeAndJoints() {
    ArmDescription ur5e = Rig.frictionless(ArmLibrary.load("ur5e"));
    double[] flange = new double[Transforms.SIZE];
    new ForwardKinematics(ur5e).flange(UP.toArray(), flange);
    assertTrue(flange[8] > 0.999, "the tool points up");
    Rig empty = new Rig(ur5e, Scene.EMPTY);
    Rig rig = new Rig(ur5e, scene(flange));
    empty.arm.jumpTo(UP);
    rig.arm.jumpTo(UP);
    empty.repeat(1500, Rig.hold(UP));
    rig.repeat(1500, Rig.hold(UP));
    Wrench felt = rig.arm.loadOnFlange();
    assertEquals(9.82, Math.sqrt(square(felt)), 0.0982);
    double leverM = Math.abs(flange[9]);
    double shoulder = rig.arm.sensors().torqueNm[1] - empty.arm.sensors().torqueNm[1];
    assertEquals(9.82 * leverM, Math.abs(shoulder), 0.1);
  }

  private static Scene scene(double[] flange) {
    List<ToolPoint> points =
        List.of(
            new ToolPoint(new Vector3(0.03, 0.03, 0.1), 0.005),
            new ToolPoint(new Vector3(0.03, -0.03, 0.1), 0.005),
            new ToolPoint(new Vector3(-0.03, 0, 0.1), 0.005));
    SceneObject box =
        new SceneObject.Box(
            "part",
            new Pose(flange[9], flange[10], flange[11] + 0.155, 0, 0, 0),
            new Vector3(0.1, 0.1, 0.1),
            Material.DEFAULT,
            1);
    return new Scene(List.of(box), Optional.empty(), points);
  }

  private static double square(Wrench felt) {
    return felt.fx() * felt.fx() + felt.fy() * felt.fy() + felt.fz() * felt.fz();
  }
}
