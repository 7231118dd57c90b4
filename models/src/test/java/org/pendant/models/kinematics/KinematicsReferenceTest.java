package org.pendant.models.kinematics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.Parameter;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.reference.ReferenceStates;

/** Kinematics against an independent implementation, at 100 random states of each arm. */
@Tag("slow")
@ParameterizedClass
@MethodSource("org.pendant.models.arm.ArmLibrary#ids")
final class KinematicsReferenceTest {
  @Parameter String armId;
  private ArmDescription arm;
  private List<ReferenceStates.State> states;

  @BeforeEach
  void load() {
    arm = ArmLibrary.load(armId);
    states = ReferenceStates.of(armId).all();
    assertEquals(100, states.size());
  }

  @Test
  void flange() {
    ForwardKinematics forward = new ForwardKinematics(arm);
    double[] transform = new double[Transforms.SIZE];
    for (ReferenceStates.State state : states) {
      forward.flange(state.numbers("q", 6), transform);
      assertArrayEquals(expectedFlange(state), transform, 1e-12);
    }
  }

  @Test
  void tcp() {
    ForwardKinematics forward = new ForwardKinematics(arm);
    for (ReferenceStates.State state : states) {
      Pose tcp = forward.tcpPose(Joints.of(state.numbers("q", 6)), tcpInFlange(state));
      double[] position = {tcp.x(), tcp.y(), tcp.z()};
      assertArrayEquals(state.numbers("tcp", 3), position, 1e-12);
    }
  }

  @Test
  void jacobian() {
    Jacobian jacobian = new Jacobian(arm);
    double[] matrix = new double[Jacobian.SIZE];
    for (ReferenceStates.State state : states) {
      jacobian.at(state.numbers("q", 6), tcpInFlange(state), matrix);
      assertArrayEquals(state.numbers("jacobian", Jacobian.SIZE), matrix, 1e-10);
    }
  }

  @Test
  void jacobianTimeDerivative() {
    Jacobian jacobian = new Jacobian(arm);
    double[] matrix = new double[Jacobian.SIZE];
    for (ReferenceStates.State state : states) {
      jacobian.derivative(
          state.numbers("q", 6), state.numbers("qd", 6), tcpInFlange(state), matrix);
      assertArrayEquals(state.numbers("jacobian_derivative", Jacobian.SIZE), matrix, 1e-8);
    }
  }

  @Test
  void solutionsHoldTheJointsOfTheState() {
    InverseKinematics inverse = new InverseKinematics(arm);
    double[][] solutions = new double[InverseKinematics.MAX_SOLUTIONS][Joints.COUNT];
    for (ReferenceStates.State state : states) {
      double[] q = state.numbers("q", 6);
      assertTrue(inverse.allInto(expectedFlange(state), q, solutions) > 0);
      assertArrayEquals(q, solutions[0], 1e-7);
    }
  }

  private static double[] expectedFlange(ReferenceStates.State state) {
    double[] flange = new double[Transforms.SIZE];
    System.arraycopy(state.numbers("flange_rotation", 9), 0, flange, 0, 9);
    System.arraycopy(state.numbers("flange_position", 3), 0, flange, 9, 3);
    return flange;
  }

  private static Pose tcpInFlange(ReferenceStates.State state) {
    double[] position = state.numbers("tcp_position", 3);
    double[] vector = state.numbers("tcp_vector", 3);
    return new Pose(position[0], position[1], position[2], vector[0], vector[1], vector[2]);
  }
}
