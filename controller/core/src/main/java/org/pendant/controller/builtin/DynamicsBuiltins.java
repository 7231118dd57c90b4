package org.pendant.controller.builtin;

import org.ejml.data.DMatrixRMaj;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Dynamics builtins: the matrices and torques of the equations of motion (manual 16.12, 16.17,
 * 16.18, 16.21). What a call leaves out is as it actually is now.
 */
final class DynamicsBuiltins {
  private static final String MODULE = "internals";

  private DynamicsBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    withSpeeds(
            withPositions(
                builtins
                    .declare("get_coriolis_and_centrifugal_torques")
                    .manual(MODULE, "16.12")
                    .doc(
                        "The torques, in Nm, that keep the joints at their speeds against Coriolis"
                            + " and centrifugal forces. The declared payload counts.")))
        .returns(Type.JOINTS)
        .effect(Effect.ASKS)
        .does(DynamicsBuiltins::coriolis);
    withTcp(
            withPositions(
                builtins
                    .declare("get_jacobian")
                    .manual(MODULE, "16.17")
                    .doc(
                        "The 6 by 6 matrix that turns joint speeds into the velocity of the TCP, in"
                            + " m/s and rad/s along the axes of the base.")))
        .returns(Type.MATRIX)
        .effect(Effect.ASKS)
        .does(DynamicsBuiltins::jacobian);
    withTcp(
            withSpeeds(
                withPositions(
                    builtins
                        .declare("get_jacobian_time_derivative")
                        .manual(MODULE, "16.18")
                        .doc("How fast the elements of the Jacobian change, per second."))))
        .returns(Type.MATRIX)
        .effect(Effect.ASKS)
        .does(DynamicsBuiltins::jacobianDerivative);
    withPositions(
            builtins
                .declare("get_mass_matrix")
                .manual(MODULE, "16.21")
                .doc(
                    "The 6 by 6 matrix that turns joint accelerations into torques, in kg m\u00b2."
                        + " The declared payload counts; the rotors of the motors if asked for."))
        .takes("include_rotors_inertia", Type.BOOL, Value.of(false))
        .alias("include_rotor_inertia")
        .returns(Type.MATRIX)
        .effect(Effect.ASKS)
        .does(DynamicsBuiltins::massMatrix);
  }

  private static Declaration<ControlBox> withPositions(Declaration<ControlBox> declaration) {
    return declaration.mayTake("q", Type.JOINTS, Unit.RADIAN, "current joint positions");
  }

  private static Declaration<ControlBox> withSpeeds(Declaration<ControlBox> declaration) {
    return declaration.mayTake("qd", Type.JOINTS, Unit.RADIAN_PER_SECOND, "current joint speeds");
  }

  private static Declaration<ControlBox> withTcp(Declaration<ControlBox> declaration) {
    return declaration.mayTake("tcp", Type.POSE, Unit.NONE, "active tcp");
  }

  private static Outcome coriolis(Call<ControlBox> call) throws ScriptError {
    double[] torqueNm = new double[Joints.COUNT];
    call.host().arm().model().dynamics().coriolis(positions(call, 0), speeds(call, 1), torqueNm);
    return call.answer(Joints.of(torqueNm));
  }

  private static Outcome jacobian(Call<ControlBox> call) throws ScriptError {
    double[] jacobian = new double[Jacobian.SIZE];
    call.host()
        .kinematics()
        .jacobian()
        .at(positions(call, 0), MotionArguments.tcpOffset(call, 1), jacobian);
    return call.answer(square(jacobian));
  }

  private static Outcome jacobianDerivative(Call<ControlBox> call) throws ScriptError {
    double[] derivative = new double[Jacobian.SIZE];
    call.host()
        .kinematics()
        .jacobian()
        .derivative(
            positions(call, 0), speeds(call, 1), MotionArguments.tcpOffset(call, 2), derivative);
    return call.answer(square(derivative));
  }

  private static Outcome massMatrix(Call<ControlBox> call) throws ScriptError {
    DMatrixRMaj mass = new DMatrixRMaj(Joints.COUNT, Joints.COUNT);
    call.host().arm().model().dynamics().mass(positions(call, 0), call.bool(1), mass);
    return call.answer(square(mass.data));
  }

  private static double[] positions(Call<ControlBox> call, int index) throws ScriptError {
    Joints q =
        call.given(index)
            ? MotionArguments.joints(call, index)
            : call.host().drive().actualPositionRad();
    return q.toArray();
  }

  private static double[] speeds(Call<ControlBox> call, int index) throws ScriptError {
    Joints qd =
        call.given(index)
            ? MotionArguments.joints(call, index)
            : call.host().arm().simulated().speedRadPerS();
    return qd.toArray();
  }

  private static MatrixValue square(double[] rows) {
    return MatrixValue.owning(Joints.COUNT, Joints.COUNT, rows, false);
  }
}
