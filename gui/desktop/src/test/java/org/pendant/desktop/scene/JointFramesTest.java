package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

final class JointFramesTest {
  private static final SceneModel MODEL = Models.of("ur5e");

  private static List<Pose> frames(Joints positionRad) {
    return JointFrames.of(MODEL.kinematics(), MODEL.arm().dh(), positionRad);
  }

  private static double[] zAxis(Pose frame) {
    double[] t = new double[Transforms.SIZE];
    Transforms.of(frame, t);
    return new double[] {t[2], t[5], t[8]};
  }

  @Test
  void theLastIsTheFlange() {
    Pose flange = MODEL.kinematics().flangePose(MODEL.positionRad());

    Pose last = frames(MODEL.positionRad()).getLast();

    for (int i = 0; i < 3; i++) {
      assertEquals(flange.get(i), last.get(i), 1e-6);
    }
  }

  @Test
  void eachAxisIsTheOneThatItsJointTurnsAbout() {
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      double[] before = zAxis(frames(MODEL.positionRad()).get(joint));
      Joints turned = MODEL.positionRad().with(joint, MODEL.positionRad().get(joint) + 1);
      double[] after = zAxis(frames(turned).get(joint));

      for (int i = 0; i < 3; i++) {
        assertEquals(before[i], after[i], 1e-5, "joint " + joint);
      }
    }
  }
}
