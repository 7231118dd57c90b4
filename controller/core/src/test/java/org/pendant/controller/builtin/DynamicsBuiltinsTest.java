package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.pose;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;

class DynamicsBuiltinsTest {
  private static final int CASES = 50;
  private static final double STEP = 1e-6;
  private static final PoseValue TCP = pose(0.03, -0.02, 0.12, 0.2, 0.1, 0);

  private final CallFixture fixture = new CallFixture();
  private final Random random = new Random(5);

  private double[] joints(double bound) {
    return random.doubles(Joints.COUNT, -bound, bound).toArray();
  }

  private static double[] along(double[] q, double[] qd, double timeS) {
    double[] moved = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      moved[i] = q[i] + timeS * qd[i];
    }
    return moved;
  }

  private MatrixValue matrix(String name, Object... arguments) throws ScriptError {
    return (MatrixValue) fixture.call(name, arguments);
  }

  private double[] tcpPosition(double[] q) throws ScriptError {
    return ((PoseValue) fixture.call("get_forward_kin", floats(q), TCP)).pose().toArray();
  }

  @Test
  void theJacobianTellsHowTheTcpMovesWithTheJoints() throws ScriptError {
    for (int n = 0; n < CASES; n++) {
      double[] q = joints(3);
      double[] qd = joints(1);
      MatrixValue jacobian = matrix("get_jacobian", floats(q), TCP);
      double[] before = tcpPosition(along(q, qd, -STEP));
      double[] after = tcpPosition(along(q, qd, STEP));
      for (int row = 0; row < 3; row++) {
        double speed = 0;
        for (int i = 0; i < Joints.COUNT; i++) {
          speed += jacobian.numberAt(row, i) * qd[i];
        }
        assertEquals((after[row] - before[row]) / (2 * STEP), speed, 1e-8, "case " + n);
      }
    }
  }

  @Test
  void theDerivativeTellsHowTheJacobianChanges() throws ScriptError {
    for (int n = 0; n < CASES; n++) {
      double[] q = joints(3);
      double[] qd = joints(1);
      MatrixValue found = matrix("get_jacobian_time_derivative", floats(q), floats(qd), TCP);
      MatrixValue before = matrix("get_jacobian", floats(along(q, qd, -STEP)), TCP);
      MatrixValue after = matrix("get_jacobian", floats(along(q, qd, STEP)), TCP);
      for (int i = 0; i < Joints.COUNT * Joints.COUNT; i++) {
        double expected = (after.numberAt(i) - before.numberAt(i)) / (2 * STEP);
        assertEquals(expected, found.numberAt(i), 1e-8, "case " + n + ", element " + i);
      }
    }
  }

  @Test
  void aPayloadAddsItsMassWhereItsCentreOfGravityMoves() throws ScriptError {
    PoseValue cog = pose(0.02, -0.03, 0.1, 0, 0, 0);
    for (int n = 0; n < CASES; n++) {
      double[] q = joints(3);
      fixture.call("set_payload", 0, floats(0, 0, 0));
      MatrixValue empty = matrix("get_mass_matrix", floats(q));
      fixture.call("set_payload", 2, floats(0.02, -0.03, 0.1));
      MatrixValue loaded = matrix("get_mass_matrix", floats(q));
      MatrixValue jacobian = matrix("get_jacobian", floats(q), cog);
      for (int i = 0; i < Joints.COUNT; i++) {
        for (int k = 0; k < Joints.COUNT; k++) {
          double added = 0;
          for (int axis = 0; axis < 3; axis++) {
            added += 2 * jacobian.numberAt(axis, i) * jacobian.numberAt(axis, k);
          }
          double found = loaded.numberAt(i, k) - empty.numberAt(i, k);
          assertEquals(added, found, 1e-9, "case " + n + ", " + i + ", " + k);
        }
      }
    }
  }

  @Test
  void rotorsCountWhenAskedFor() throws ScriptError {
    NumberList q = floats(0.1, -1, 0.5, 1, -0.4, 2);
    MatrixValue without = matrix("get_mass_matrix", q);
    MatrixValue with = matrix("get_mass_matrix", q, true);
    for (int i = 0; i < Joints.COUNT; i++) {
      double rotor = ArmLibrary.load("ur5e").actuators().get(i).rotorInertiaKgM2();
      assertEquals(rotor, with.numberAt(i, i) - without.numberAt(i, i), 1e-12);
      assertEquals(without.numberAt(i, (i + 1) % 6), with.numberAt(i, (i + 1) % 6));
    }
  }

  @Test
  void centrifugalTorquesDoTheWorkThatTheMassMatrixTakes() throws ScriptError {
    // qd C qd is half of qd M' qd: their sum changes no kinetic energy
    for (int n = 0; n < CASES; n++) {
      double[] q = joints(3);
      double[] qd = joints(2);
      NumberList torque =
          (NumberList) fixture.call("get_coriolis_and_centrifugal_torques", floats(q), floats(qd));
      MatrixValue before = matrix("get_mass_matrix", floats(along(q, qd, -STEP)));
      MatrixValue after = matrix("get_mass_matrix", floats(along(q, qd, STEP)));
      double power = 0;
      double half = 0;
      for (int i = 0; i < Joints.COUNT; i++) {
        power += qd[i] * torque.numberAt(i);
        for (int k = 0; k < Joints.COUNT; k++) {
          double change = (after.numberAt(i, k) - before.numberAt(i, k)) / (2 * STEP);
          half += 0.5 * qd[i] * change * qd[k];
        }
      }
      assertEquals(half, power, 1e-6 * Math.max(1, Math.abs(half)), "case " + n);
    }
  }

  @Test
  void whatIsLeftOutIsAsItActuallyIs() throws ScriptError {
    NumberList here = floats(fixture.box().drive().actualPositionRad().toArray());
    PoseValue none = pose(0, 0, 0, 0, 0, 0);
    assertEquals(matrix("get_jacobian", here, none), matrix("get_jacobian"));
    fixture.call("set_tcp", TCP);
    assertEquals(matrix("get_jacobian", here, TCP), matrix("get_jacobian"));
    assertEquals(matrix("get_mass_matrix", here, false), matrix("get_mass_matrix"));
    assertEquals("[0, 0, 0, 0, 0, 0]", fixture.call("get_coriolis_and_centrifugal_torques").text());
    double largest = 0;
    MatrixValue atRest = matrix("get_jacobian_time_derivative");
    for (int i = 0; i < Joints.COUNT * Joints.COUNT; i++) {
      largest = Math.max(largest, Math.abs(atRest.numberAt(i)));
    }
    assertEquals(0, largest);
  }

  @Test
  void jointsAreSixFiniteNumbers() {
    refuses(
        "wrong-type",
        "get_jacobian: q is list [1, 2], must be a list of 6 numbers",
        () -> fixture.call("get_jacobian", floats(1, 2)));
    refuses(
        "value-out-of-range",
        "qd is [0, 0, 0, 0, 0, nan], must be finite",
        () ->
            fixture.call(
                "get_coriolis_and_centrifugal_torques",
                floats(0, 0, 0, 0, 0, 0),
                floats(0, 0, 0, 0, 0, Double.NaN)));
    refuses(
        "wrong-type",
        "include_rotors_inertia is string yes",
        () -> fixture.call("get_mass_matrix", floats(0, 0, 0, 0, 0, 0), "yes"));
  }
}
