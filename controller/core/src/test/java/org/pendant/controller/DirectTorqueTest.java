package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ArmState;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.script.vm.ProgramState;

/** Programs that drive the arm by torques (manual 15.2). */
final class DirectTorqueTest {
  private static final Joints READY = new Joints(0, -1.5708, -1.5708, -1.5708, 1.5708, 0);

  private final RunningProgram running = new RunningProgram();

  private ArmState arm() {
    return running.state().arm();
  }

  /** Starts to give these torques, and lets that continue for a number of frames. */
  private void drive(String torques, String friction, int frames) {
    running.start(
        """
        def torque():
          movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])
          textmsg("begun")
          i = 0
          while i < %d:
            direct_torque(%s, friction_comp=%s)
            i = i + 1
          end
        end
        """
            .formatted(frames, torques, friction));
    while (running.said().isEmpty()) {
      running.advance(1);
    }
    running.advance(frames - 1);
  }

  @Test
  void withoutTorquesTheArmStaysWhereItIs() {
    drive("[0, 0, 0, 0, 0, 0]", "True", 5000);
    assertEquals(0, arm().actualPositionRad().maxAbsDifference(READY), 1.7e-4);
  }

  @Test
  void aConstantTorqueSpeedsUpByItsInertia() {
    ArmDescription ur5e = ArmLibrary.load("ur5e");
    DMatrixRMaj mass = new DMatrixRMaj(Joints.COUNT, Joints.COUNT);
    new ArmDynamics(ur5e).mass(READY.toArray(), true, mass);
    double coulomb = ur5e.actuators().get(5).dryNm(0);
    double slow = ur5e.actuators().get(5).speedDependentNmSPerRad(0);
    double fast = ur5e.actuators().get(5).speedDependentNmSPerRad(1.5);
    drive("[0, 0, 0, 0, 0, 3]", "False", 51);
    double speed = arm().actualSpeedRadPerS().q5();
    double inertia = mass.get(5, 5);
    // I w' = torque - coulomb - c(w) w, c between that at rest and that at more than this speed
    double early = (3 - coulomb) / slow * (1 - Math.exp(-slow / inertia * 0.098));
    double late = (3 - coulomb) / fast * (1 - Math.exp(-fast / inertia * 0.106));
    assertTrue(speed > 0.97 * early && speed < 1.03 * late, early + " < " + speed + " < " + late);
    assertTrue(late < 1.5 && late < 1.2 * early, early + " < " + late);
  }

  @Test
  void compensationOfFrictionMakesItFaster() {
    drive("[0, 0, 0, 0, 0, 3]", "False", 50);
    RunningProgram uncompensated = running;
    DirectTorqueTest compensated = new DirectTorqueTest();
    compensated.drive("[0, 0, 0, 0, 0, 3]", "True", 50);
    assertTrue(
        compensated.arm().actualSpeedRadPerS().q5()
            > uncompensated.state().arm().actualSpeedRadPerS().q5() * 1.1);
  }

  @Test
  void theFrictionThatIsOvercomeCanBeGivenJointByJoint() {
    String shares = "[0, 0, 0, 0, 0, 0.8]";
    drive("[0, 0, 0, 0, 0, 3]", "True", 50);
    DirectTorqueTest given = new DirectTorqueTest();
    given.drive(
        "[0, 0, 0, 0, 0, 3]", "False, viscous_scale=" + shares + ", coulomb_scale=" + shares, 50);
    assertEquals(arm().actualSpeedRadPerS().q5(), given.arm().actualSpeedRadPerS().q5(), 1e-9);
    DirectTorqueTest viscousOnly = new DirectTorqueTest();
    viscousOnly.drive("[0, 0, 0, 0, 0, 3]", "False, viscous_scale=" + shares, 50);
    assertTrue(
        viscousOnly.arm().actualSpeedRadPerS().q5() < arm().actualSpeedRadPerS().q5() * 0.95);
  }

  @Test
  void theTargetFollowsTheArmAndHasNoAcceleration() {
    drive("[0, 0, 0, 0, 0, 3]", "True", 50);
    assertEquals(arm().actualPositionRad(), arm().targetPositionRad());
    assertEquals(arm().actualSpeedRadPerS(), arm().targetSpeedRadPerS());
    assertEquals(Joints.ZERO, arm().targetAccelerationRadPerS2());
    assertTrue(arm().moving());
    assertFalse(arm().steady());
  }

  @Test
  void aMissingCallBringsTheArmToRestFromWhereItIs() {
    drive("[0, 0, 0, 0, 0, 3]", "True", 50);
    Joints before = arm().targetPositionRad();
    double speed = arm().targetSpeedRadPerS().q5();
    assertTrue(speed > 0.2);
    running.advance(1);
    double moved = arm().targetPositionRad().q5() - before.q5();
    assertTrue(moved > 0 && moved < 2 * speed * 0.002, "moved by " + moved);
    running.advance(300);
    assertEquals(Joints.ZERO, arm().targetSpeedRadPerS());
    assertEquals(0, arm().actualSpeedRadPerS().maxAbsDifference(Joints.ZERO), 1e-4);
    assertEquals(SafetyMode.NORMAL, running.state().safety().safetyMode());
    assertFalse(arm().moving());
  }

  @Test
  void aCallTakesOneFrameWhateverTheSlider() {
    running.done(new BoxCommand.SetSpeedFraction(0.1));
    running.start(
        """
        def torque():
          before = time()
          i = 0
          while i < 100:
            direct_torque([0, 0, 0, 0, 0, 0])
            i = i + 1
          end
          after = time()
          textmsg(floor((after.nanosec - before.nanosec) / 1000000 + 0.5))
        end
        """);
    running.finish();
    assertEquals(200, running.numbers().getLast());
  }

  @Test
  void aJointThatNearsTheEndOfItsRangeIsStopped() {
    running.start(
        """
        def torque():
          while True:
            speeds = get_actual_joint_speeds()
            direct_torque([0, 0, 0, 10 * (-1.5 - speeds[3]), 0, 0])
          end
        end
        """);
    for (int i = 0; i < 5000 && running.programState() == ProgramState.RUNNING; i++) {
      running.advance(1);
    }
    assertEquals(SafetyMode.PROTECTIVE_STOP, running.state().safety().safetyMode());
    assertTrue(
        running.reported().stream().anyMatch(line -> line.startsWith("C150A3")),
        () -> running.reported().toString());
    assertRestsBeforeTheLimit();
  }

  /** The safety limit is three degrees behind the end of the joint's range. */
  private void assertRestsBeforeTheLimit() {
    running.advance(200);
    double end = arm().actualPositionRad().q3();
    assertTrue(end > -2 * Math.PI - Math.toRadians(3), "rests at " + Math.toDegrees(end));
    assertEquals(Joints.ZERO, arm().targetSpeedRadPerS());
  }

  @Test
  void aJointThatSpeedsUpAtTheEndOfItsRangeIsStoppedAsWell() {
    running.start(
        """
        def torque():
          while True:
            torque = -28
            if get_actual_joint_positions()[3] > -6.1:
              speeds = get_actual_joint_speeds()
              torque = 10 * (-1.5 - speeds[3])
            end
            direct_torque([0, 0, 0, torque, 0, 0])
          end
        end
        """);
    for (int i = 0; i < 5000 && running.programState() == ProgramState.RUNNING; i++) {
      running.advance(1);
    }
    assertEquals(SafetyMode.PROTECTIVE_STOP, running.state().safety().safetyMode());
    assertRestsBeforeTheLimit();
  }

  @Test
  void aJointThatTurnsTooFastIsAViolation() {
    running.start(
        """
        def torque():
          while True:
            direct_torque([0, 0, 0, 0, 0, 20])
          end
        end
        """);
    for (int i = 0; i < 5000 && running.programState() == ProgramState.RUNNING; i++) {
      running.advance(1);
    }
    assertEquals(SafetyMode.VIOLATION, running.state().safety().safetyMode());
    assertTrue(
        running.reported().stream().anyMatch(line -> line.startsWith("C191A1")),
        () -> running.reported().toString());
  }

  @Test
  void randomTorquesLeaveNumbersFiniteAndTheArmAtRest() {
    SplittableRandom random = new SplittableRandom(5);
    for (int each = 0; each < 20; each++) {
      RunningProgram one = new RunningProgram();
      StringBuilder body = new StringBuilder();
      for (int i = 0; i < 60; i++) {
        body.append("  direct_torque([");
        for (int k = 0; k < Joints.COUNT; k++) {
          double most = random.nextInt(10) == 0 ? 1e6 : 30;
          body.append(k == 0 ? "" : ", ").append(most * (2 * random.nextDouble() - 1));
        }
        body.append("], ").append(random.nextBoolean() ? "True" : "False").append(")\n");
      }
      String text = "def torque():\n" + body + "  stopj(10)\nend\n";
      one.start(text);
      for (int i = 0; i < 600; i++) {
        one.advance(1);
        ArmState arm = one.state().arm();
        assertTrue(arm.actualPositionRad().isFinite() && arm.actualSpeedRadPerS().isFinite(), text);
        assertTrue(arm.targetPositionRad().isFinite() && arm.targetSpeedRadPerS().isFinite(), text);
      }
      assertEquals(Joints.ZERO, one.state().arm().targetSpeedRadPerS(), text);
      assertTrue(one.programState() != ProgramState.RUNNING, text);
    }
  }
}
