package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.time.FrameTime;

/** The tool goes straight down onto a table that is 20 mm below it. */
@Tag("slow")
class ContactTest {
  private static final double GAP_M = 0.02;

  static Stream<String> allArms() {
    return ArmLibrary.ids().stream();
  }

  @Test
  void tableDrivenFiveMillimetresDeepPushesBackByItsStiffness() {
    Rig rig = above("ur5e", new Material(4e4, 0.2, 0.3));

    Joints target = lower(rig, GAP_M + 0.005, 0.1);
    rig.framesToRest(target);

    // the servos integrate until the joints are within 5e-5 rad of the target
    assertEquals(200, contactForceN(rig), 4);
    assertEquals(200, rig.arm.loadOnFlange().fz() * -1, 4);
  }

  @Test
  void liftedToolComesFree() {
    Rig rig = above("ur5e", new Material(4e4, 0.2, 0.3));
    lower(rig, GAP_M + 0.002, 0.1);
    assertTrue(rig.world.inContact());

    rig.worstWhileMoving(rig.arm.positionRad(), Rig.START);

    assertFalse(rig.world.inContact());
    rig.framesToRest(Rig.START);
  }

  @ParameterizedTest
  @MethodSource("allArms")
  void stiffestTableIsTouchedWithoutBouncingOn(String id) {
    ArmDescription description = ArmLibrary.load(id);
    Material[] materials = {
      new Material(2e5, 0, 0), new Material(2e5, 2, 2), new Material(2e5, 0.2, 0.3)
    };
    for (Material material : materials) {
      for (double share : new double[] {0, 1}) {
        Rig rig = above(id, material);
        Payload payload = Rig.rated(description, share);
        rig.carrying(payload, payload);

        Joints target = lower(rig, GAP_M + 0.0003, 0.25);
        rig.repeat(4000, Rig.hold(target));

        String where = material + " with " + payload.massKg() + " kg";
        double force = contactForceN(rig);
        assertTrue(force > 1 && force < 150, where + ": " + force + " N");
        for (int frame = 0; frame < 100; frame++) {
          rig.arm.step(Rig.hold(target));
          assertEquals(force, contactForceN(rig), 2, where);
        }
        assertTrue(rig.arm.speedRadPerS().maxAbsDifference(Joints.ZERO) < 1e-3, where);
      }
    }
  }

  private static Rig above(String id, Material material) {
    ArmDescription description = ArmLibrary.load(id);
    double flangeZ = new ForwardKinematics(description).flangePose(Rig.START).z();
    Scene scene =
        new Scene(
            List.of(
                new SceneObject.Plane(
                    "table", new Vector3(0, 0, flangeZ - GAP_M), new Vector3(0, 0, 1), material)),
            Optional.empty(),
            List.of());
    return new Rig(description, scene);
  }

  /** Moves the target straight down; returns its joint positions. */
  private static Joints lower(Rig rig, double depthM, double speedMPerS) {
    ForwardKinematics forward = new ForwardKinematics(rig.description);
    InverseKinematics inverse = new InverseKinematics(rig.description);
    Pose start = forward.flangePose(Rig.START);
    double[] flange = new double[Transforms.SIZE];
    double[] q = Rig.START.toArray();
    Joints before = Rig.START;
    int frames = (int) Math.ceil(depthM / (speedMPerS * FrameTime.FRAME_S));
    for (int frame = 1; frame <= frames; frame++) {
      Transforms.of(start.with(2, start.z() - depthM * frame / frames), flange);
      assertTrue(inverse.track(flange, q));
      Joints target = Joints.of(q);
      rig.arm.step(new ArmCommand.Servo(target, speed(before, target), Joints.ZERO));
      before = target;
    }
    return before;
  }

  private static Joints speed(Joints from, Joints to) {
    double[] speed = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      speed[i] = (to.get(i) - from.get(i)) / FrameTime.FRAME_S;
    }
    return Joints.of(speed);
  }

  private static double contactForceN(Rig rig) {
    return rig.world.contacts().isEmpty() ? 0 : rig.world.contacts().getFirst().forceN();
  }
}
