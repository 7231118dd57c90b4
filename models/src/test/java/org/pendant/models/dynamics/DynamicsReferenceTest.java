package org.pendant.models.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.Parameter;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Transforms;
import org.pendant.models.reference.ReferenceStates;

/** Dynamics against an independent implementation, at 100 random states of each arm. */
@ParameterizedClass
@MethodSource("org.pendant.models.arm.ArmLibrary#ids")
@Tag("slow")
final class DynamicsReferenceTest {
  private static final double RELATIVE = 1e-8;

  @Parameter String armId;
  private ArmDynamics dynamics;
  private List<ReferenceStates.State> states;
  private final double[] torque = new double[6];

  @BeforeEach
  void load() {
    dynamics = new ArmDynamics(ArmLibrary.load(armId));
    states = ReferenceStates.of(armId).all();
    assertEquals(100, states.size());
  }

  private static void assertClose(double[] expected, double[] actual, String what) {
    double size = 0;
    for (double each : expected) {
      size = Math.max(size, Math.abs(each));
    }
    for (int i = 0; i < expected.length; i++) {
      assertEquals(expected[i], actual[i], RELATIVE * size, what + " " + i);
    }
  }

  @Test
  void massMatrix() {
    DMatrixRMaj mass = new DMatrixRMaj(6, 6);
    for (ReferenceStates.State state : states) {
      dynamics.mass(state.numbers("q", 6), false, mass);
      assertClose(state.numbers("mass", 36), mass.data, "mass");
    }
  }

  @Test
  void coriolisAndCentrifugalTorques() {
    for (ReferenceStates.State state : states) {
      dynamics.coriolis(state.numbers("q", 6), state.numbers("qd", 6), torque);
      assertClose(state.numbers("coriolis", 6), torque, "coriolis");
    }
  }

  @Test
  void gravityTorques() {
    for (ReferenceStates.State state : states) {
      dynamics.gravity(state.numbers("q", 6), torque);
      assertClose(state.numbers("gravity", 6), torque, "gravity");
    }
  }

  @Test
  void torquesOfAMotionWithPayloadOnAMovingBase() {
    for (ReferenceStates.State state : states) {
      load(state);
      dynamics.inverse(
          state.numbers("q", 6), state.numbers("qd", 6), state.numbers("qdd", 6), torque);
      assertClose(state.numbers("torque", 6), torque, "torque");
    }
  }

  @Test
  void gravityAndBaseAccelerationAddUp() {
    for (ReferenceStates.State state : states) {
      load(state);
      double[] felt = state.numbers("felt", 3);
      dynamics.setGravity(0, 0, 9.82);
      dynamics.setBaseAcceleration(felt[0], felt[1], felt[2] - 9.82);
      dynamics.inverse(
          state.numbers("q", 6), state.numbers("qd", 6), state.numbers("qdd", 6), torque);
      assertClose(state.numbers("torque", 6), torque, "torque");
    }
  }

  @Test
  void momentumAndKineticEnergyWithPayload() {
    double[] momentum = new double[3];
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    for (ReferenceStates.State state : states) {
      load(state);
      double[] q = state.numbers("q", 6);
      double[] qd = state.numbers("qd", 6);
      dynamics.linearMomentum(q, qd, momentum);
      assertClose(state.numbers("momentum", 3), momentum, "momentum");
      new ForwardKinematics(ArmLibrary.load(armId)).frames(q, frames);
      dynamics.linearMomentum(frames, qd, momentum);
      assertClose(state.numbers("momentum", 3), momentum, "momentum by frames");
      double energy = state.number("kinetic_energy");
      assertEquals(energy, dynamics.kineticEnergyJ(q, qd), RELATIVE * energy);
    }
  }

  private void load(ReferenceStates.State state) {
    double[] cog = state.numbers("payload_cog", 3);
    double[] i = state.numbers("payload_inertia", 6);
    double[] felt = state.numbers("felt", 3);
    dynamics.setPayload(
        new Payload(
            state.number("payload_mass"),
            cog[0],
            cog[1],
            cog[2],
            i[0],
            i[1],
            i[2],
            i[3],
            i[4],
            i[5]));
    dynamics.setGravity(felt[0], felt[1], felt[2]);
    dynamics.setBaseAcceleration(0, 0, 0);
  }
}
