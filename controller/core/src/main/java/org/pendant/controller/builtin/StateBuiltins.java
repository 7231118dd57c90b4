package org.pendant.controller.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.box.ToolFlange;
import org.pendant.language.signature.Type;
import org.pendant.models.pose.Pose;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * State builtins: where the arm is, should be and is going, and its tool (manual 16.4 to 16.9,
 * 16.24 to 16.53).
 */
final class StateBuiltins {
  private static final String MODULE = "internals";

  private StateBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareActual(builtins);
    declareTargetJoints(builtins);
    declareTargetTcp(builtins);
    declareTool(builtins);
  }

  private static void declareActual(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_actual_joint_positions")
        .manual(MODULE, "16.4")
        .doc("Where the joints are, in rad.")
        .returns(Type.JOINTS)
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().arm().simulated().positionRad()));
    builtins
        .declare("get_joint_positions")
        .manual(MODULE, "16.4")
        .doc("Where the joints are, in rad. The name in old programs.")
        .returns(Type.JOINTS)
        .deprecated("get_actual_joint_positions")
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().arm().simulated().positionRad()));
    builtins
        .declare("get_actual_joint_speeds")
        .manual(MODULE, "16.6")
        .doc("How fast the joints turn, in rad/s.")
        .returns(Type.JOINTS)
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().arm().simulated().speedRadPerS()));
    builtins
        .declare("get_actual_tcp_pose")
        .manual(MODULE, "16.7")
        .doc("Where the TCP is, in the base frame.")
        .returns(Type.POSE)
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().kinematics().actualTcpInBase()));
    builtins
        .declare("tool_pose")
        .manual(MODULE, "16.7")
        .doc("Where the TCP is, in the base frame: what older programs and force nodes call.")
        .returns(Type.POSE)
        .deprecated("get_actual_tcp_pose")
        .does(call -> call.answer(call.host().kinematics().actualTcpInBase()));
    builtins
        .declare("get_actual_tcp_speed")
        .manual(MODULE, "16.8")
        .doc("How fast the TCP moves, in m/s and rad/s along the axes of the base frame.")
        .returns(Type.POSE)
        .effect(Effect.SENSES)
        .does(StateBuiltins::actualTcpSpeed);
    builtins
        .declare("get_actual_tool_flange_pose")
        .manual(MODULE, "16.9")
        .doc("Where the flange is, in the base frame, whatever the TCP.")
        .returns(Type.POSE)
        .effect(Effect.SENSES)
        .does(
            call ->
                call.answer(
                    call.host()
                        .kinematics()
                        .forward()
                        .flangePose(call.host().arm().simulated().positionRad())));
  }

  private static void declareTargetJoints(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_target_joint_accelerations")
        .manual(MODULE, "16.23")
        .doc("How fast the speeds of the joints should change, in rad/s\u00b2.")
        .returns(Type.JOINTS)
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().motion().accelerationRadPerS2()));
    builtins
        .declare("get_target_joint_positions")
        .manual(MODULE, "16.24")
        .doc("Where the joints should be, in rad.")
        .returns(Type.JOINTS)
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().motion().positionRad()));
    builtins
        .declare("get_target_joint_speeds")
        .manual(MODULE, "16.25")
        .doc("How fast the joints should turn, in rad/s.")
        .returns(Type.JOINTS)
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().motion().speedRadPerS()));
  }

  private static void declareTargetTcp(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_target_tcp_pose")
        .manual(MODULE, "16.29")
        .doc("Where the TCP should be, in the base frame.")
        .returns(Type.POSE)
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().kinematics().targetTcpInBase()));
    builtins
        .declare("get_target_tcp_speed")
        .manual(MODULE, "16.30")
        .doc("How fast the TCP should move, in m/s and rad/s along the axes of the base frame.")
        .returns(Type.POSE)
        .effect(Effect.SENSES)
        .does(StateBuiltins::targetTcpSpeed);
    builtins
        .declare("get_target_waypoint")
        .manual(MODULE, "16.31")
        .doc("Where the active move takes the TCP; at rest where the TCP should be.")
        .returns(Type.POSE)
        .effect(Effect.ASKS_GOAL)
        .does(StateBuiltins::waypoint);
    builtins
        .declare("is_steady")
        .manual(MODULE, "16.39")
        .doc("Whether the arm has been told to rest for the last 500 ms.")
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().motion().steady()));
  }

  private static void declareTool(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_tcp_offset")
        .manual(MODULE, "16.33")
        .doc("The pose of the active TCP in the flange frame.")
        .returns(Type.POSE)
        .effect(Effect.ASKS)
        .does(call -> call.answer(call.host().flange().tool().inFlange()));
    builtins
        .declare("set_tcp")
        .manual(MODULE, "16.53")
        .doc("Makes a pose in the flange frame the active TCP, under a name.")
        .needs("pose", Type.POSE)
        .takes("tcp_name", Type.STRING, Value.of(""))
        .effect(Effect.SETS)
        .does(StateBuiltins::setTcp);
  }

  private static Outcome actualTcpSpeed(Call<ControlBox> call) {
    ControlBox box = call.host();
    return call.answer(
        box.kinematics()
            .tcpTwistInBase(
                box.arm().simulated().positionRad(), box.arm().simulated().speedRadPerS()));
  }

  private static Outcome targetTcpSpeed(Call<ControlBox> call) {
    ControlBox box = call.host();
    return call.answer(
        box.kinematics().tcpTwistInBase(box.motion().positionRad(), box.motion().speedRadPerS()));
  }

  private static Outcome waypoint(Call<ControlBox> call) {
    ControlBox box = call.host();
    Pose waypoint = box.motion().waypoint().orElseGet(box.kinematics()::targetTcpInBase);
    return call.answer(waypoint);
  }

  private static Outcome setTcp(Call<ControlBox> call) throws ScriptError {
    ToolCentre wanted = new ToolCentre(MotionArguments.pose(call, 0), call.text(1));
    ToolFlange flange = call.host().flange();
    if (!call.program().foreseesSetting(wanted.inFlange().equals(flange.tool().inFlange()))) {
      flange.setTool(wanted);
    }
    return call.answer();
  }
}
