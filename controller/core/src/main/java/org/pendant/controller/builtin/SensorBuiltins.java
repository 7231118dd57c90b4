package org.pendant.controller.builtin;

import org.pendant.controller.arm.WarmUp;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.PositionHistory;
import org.pendant.controller.sensor.ArmSensors;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Sensor builtins: what the sensors read (manual 16.1, 16.3, 16.5, 16.11, 16.19, 16.20, 16.32 to
 * 16.36, 18.72).
 */
final class SensorBuiltins {
  private static final String MODULE = "internals";

  private SensorBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareForce(builtins);
    declareJoints(builtins);
    declareTool(builtins);
    builtins
        .declare("get_controller_temp")
        .manual(MODULE, "16.11")
        .doc("The temperature in the control box.")
        .returns(Unit.CELSIUS)
        .effect(Effect.SENSES)
        .does(call -> call.answer(WarmUp.CONTROL_BOX.temperatureC(call.host().clock().timeS())));
  }

  private static void declareForce(Builtins<ControlBox> builtins) {
    builtins
        .declare("force")
        .manual(MODULE, "16.1")
        .doc(
            "How strongly something pushes or pulls the tool: the length of get_tcp_force's force.")
        .returns(Unit.NEWTON)
        .effect(Effect.SENSES)
        .does(SensorBuiltins::force);
    builtins
        .declare("get_tcp_force")
        .manual(MODULE, "16.32")
        .doc(
            "Force in N and torque in Nm that act on the tool from outside, at the flange along the"
                + " axes of the base. Weight and inertia of the declared payload do not count.")
        .returns(Type.POSE)
        .effect(Effect.SENSES)
        .does(SensorBuiltins::tcpForce);
    builtins
        .declare("zero_ftsensor")
        .manual("interfaces", "18.72")
        .doc("Makes what the force sensor feels now its zero.")
        .does(
            call -> {
              call.host().flange().zeroForceSensor();
              return call.answer();
            });
  }

  private static void declareJoints(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_actual_joint_accelerations")
        .manual(MODULE, "16.3")
        .doc("How fast the speeds of the joints change, from the encoders, in rad/s\u00b2.")
        .returns(Type.JOINTS)
        .effect(Effect.SENSES)
        .does(call -> call.answer(sensors(call).accelerationRadPerS2()));
    builtins
        .declare("get_actual_joint_positions_history")
        .manual(MODULE, "16.5")
        .doc("Where the joints were some frames ago, in rad; the last 1000 frames are kept.")
        .takes("steps", Type.INT, Value.of(0))
        .returns(Type.JOINTS)
        .effect(Effect.SENSES)
        .does(SensorBuiltins::history);
    builtins
        .declare("get_joint_temp")
        .manual(MODULE, "16.19")
        .doc("The temperature of a joint, 0 for the base to 5 for wrist 3.")
        .needs("j", Type.INT)
        .returns(Unit.CELSIUS)
        .effect(Effect.SENSES)
        .does(
            call ->
                call.answer(
                    sensors(call).temperatureC().get(call.integer(0, 0, Joints.COUNT - 1))));
    builtins
        .declare("get_joint_torques")
        .manual(MODULE, "16.20")
        .doc(
            "What the torques of the joints, in Nm, have beyond those that arm and declared payload"
                + " need themselves.")
        .returns(Type.JOINTS)
        .effect(Effect.SENSES)
        .does(SensorBuiltins::externalTorques);
  }

  private static void declareTool(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_tool_accelerometer_reading")
        .manual(MODULE, "16.34")
        .doc(
            "What the accelerometer in the flange reads along the flange's axes, in m/s\u00b2; at"
                + " rest an axis that points up reads gravity.")
        .returns(Type.LIST)
        .effect(Effect.SENSES)
        .does(SensorBuiltins::accelerometer);
    builtins
        .declare("get_tool_current")
        .manual(MODULE, "16.35")
        .doc("The current that the tool takes.")
        .returns(Unit.AMPERE)
        .effect(Effect.SENSES)
        .does(SensorBuiltins::toolCurrent);
    builtins
        .declare("get_tool_temp")
        .manual(MODULE, "16.36")
        .doc("The temperature in the tool flange.")
        .returns(Unit.CELSIUS)
        .effect(Effect.SENSES)
        .does(call -> call.answer(sensors(call).toolTemperatureC()));
  }

  private static ArmSensors sensors(Call<ControlBox> call) {
    return call.host().arm().simulated().sensors();
  }

  private static Outcome force(Call<ControlBox> call) {
    Wrench w = call.host().flange().wrenchInBase().wrench();
    return call.answer(Math.sqrt(w.fx() * w.fx() + w.fy() * w.fy() + w.fz() * w.fz()));
  }

  private static Outcome tcpForce(Call<ControlBox> call) {
    Wrench w = call.host().flange().wrenchInBase().wrench();
    return call.answer(new Pose(w.fx(), w.fy(), w.fz(), w.mx(), w.my(), w.mz()));
  }

  private static Outcome history(Call<ControlBox> call) throws ScriptError {
    int steps = call.integer(0, 0, PositionHistory.FRAMES - 1);
    ControlBox box = call.host();
    // not from the history: set_pos may have put the arm elsewhere in this frame
    return call.answer(
        steps == 0 ? box.drive().actualPositionRad() : box.drive().history().ago(steps));
  }

  private static Outcome externalTorques(Call<ControlBox> call) {
    double[] torqueNm = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      torqueNm[i] = sensors(call).externalTorqueNm(i);
    }
    return call.answer(Joints.of(torqueNm));
  }

  private static Outcome toolCurrent(Call<ControlBox> call) {
    ControlBox box = call.host();
    return call.answer(box.signals().toolCurrentA(box.drive().powered()));
  }

  private static Outcome accelerometer(Call<ControlBox> call) {
    ArmSensors sensors = sensors(call);
    return call.answer(
        NumberList.of(
            sensors.toolAccelerationMPerS2(0),
            sensors.toolAccelerationMPerS2(1),
            sensors.toolAccelerationMPerS2(2)));
  }
}
