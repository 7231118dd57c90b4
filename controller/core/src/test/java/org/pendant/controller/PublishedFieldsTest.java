package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.InstantSource;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.rtde.FieldType;
import org.pendant.controller.rtde.OutputField;
import org.pendant.controller.rtde.OutputFields;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/** What clients read of a controller at work. */
final class PublishedFieldsTest {
  private static final String STRETCHED = "movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])\n";

  private final RunningProgram robot = new RunningProgram();

  private double element(String name, FieldType type, int index) {
    OutputField field = OutputFields.of(name).orElseThrow();
    assertEquals(type, field.type());
    return field.quantity().numbers(robot.state())[field.from() + index];
  }

  private double number(String name) {
    return element(name, FieldType.DOUBLE, 0);
  }

  private int integer(String name) {
    return (int) element(name, FieldType.INT32, 0);
  }

  private int bits(String name) {
    return (int) element(name, FieldType.UINT32, 0);
  }

  private long longBits(String name) {
    return (long) element(name, FieldType.UINT64, 0);
  }

  private double element(String name, int index) {
    return element(name, FieldType.VECTOR6D, index);
  }

  private double element3(String name, int index) {
    return element(name, FieldType.VECTOR3D, index);
  }

  private int jointMode(int joint) {
    return (int) element("joint_mode", FieldType.VECTOR6INT32, joint);
  }

  @Test
  void modesFollowThePowerOfTheArm() {
    assertEquals(7, integer("robot_mode"));
    assertEquals(253, jointMode(0));
    assertEquals(253, bits("tool_mode"));
    assertEquals(1, bits("robot_status_bits"));
    robot.ask(new SafetyCommand.PowerOff());
    robot.advance(2000);
    assertEquals(3, integer("robot_mode"));
    assertEquals(239, jointMode(5));
    assertEquals(239, bits("tool_mode"));
    assertEquals(0, bits("robot_status_bits"));
    assertEquals(0, number("actual_robot_voltage"));
    assertEquals(0, number("actual_robot_current"));
    assertEquals(0, element("actual_joint_voltage", 3));
    assertEquals(48, number("actual_main_voltage"));
  }

  @Test
  void aRunningProgramShowsInStatusBitsAndLine() {
    robot.start("def p():\n  sleep(1)\nend\n");
    robot.advance(5);
    assertEquals(3, bits("robot_status_bits"));
    assertEquals(2, bits("runtime_state"));
    assertEquals(2, bits("script_control_line"));
    robot.done(new ProgramCommand.PauseProgram());
    assertEquals(1, bits("robot_status_bits"));
    assertEquals(4, bits("runtime_state"));
  }

  @Test
  void aHandThatGuidesTheArmIsATeachButton() {
    robot.done(new ManualCommand.StartFreedrive(FreeAxes.ALL, FreedriveFrame.BASE));
    assertEquals(5, bits("robot_status_bits"));
  }

  @Test
  void safetyBitsTellTheKindOfStop() {
    assertEquals(1, bits("safety_status_bits"));
    robot.ask(new SafetyCommand.SetSafetyInput(SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP, true));
    assertEquals(1 << 4 | 1 << 10, bits("safety_status_bits"));
    assertEquals(5, integer("safety_mode"));
    assertEquals(12, integer("safety_status"));
    robot.ask(new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true));
    assertEquals(1 << 6 | 1 << 7 | 1 << 10, bits("safety_status_bits"));
    assertEquals(7, integer("safety_mode"));
  }

  @Test
  void reducedLimitsAreAMode() {
    robot.ask(new SafetyCommand.SetSafetyInput(SafetyInput.REDUCED_MODE, true));
    robot.advance(2);
    assertEquals(2, bits("safety_status_bits"));
    assertEquals(2, integer("safety_mode"));
  }

  @Test
  void aProtectiveStopShows() {
    robot.start("protective_stop()\nsleep(1)\n");
    robot.advance(2);
    assertEquals(1 << 2 | 1 << 10, bits("safety_status_bits"));
    assertEquals(3, integer("safety_mode"));
  }

  @Test
  void digitalSignalsStandTogetherInOneField() {
    robot.done(
        new IoCommand.WriteSignals(
            new SignalWrite.Digital(new Signal(SignalBank.STANDARD_OUT, 2), true)));
    robot.done(
        new IoCommand.WriteSignals(
            new SignalWrite.Digital(new Signal(SignalBank.CONFIGURABLE_OUT, 0), true)));
    robot.done(
        new IoCommand.WriteSignals(
            new SignalWrite.Digital(new Signal(SignalBank.TOOL_OUT, 1), true)));
    robot.done(new IoCommand.SetInput("tool_in[0]", true));
    robot.done(new IoCommand.SetInput("configurable_in[7]", true));
    assertEquals(1 << 2 | 1 << 8 | 1 << 17, longBits("actual_digital_output_bits"));
    assertEquals(1 << 15 | 1 << 16, longBits("actual_digital_input_bits"));
    assertEquals(1 << 7, longBits("actual_configurable_digital_input_bits"));
    assertEquals(0.02, number("io_current"), 1e-12);
  }

  @Test
  void theToolTakesMoreThatIsSuppliedAndSwitched() {
    assertEquals(0.08, number("tool_output_current"), 1e-12);
    robot.run("set_tool_voltage(24)\n");
    assertEquals(0.08 + 0.025, number("tool_output_current"), 1e-12);
    robot.run("set_tool_digital_out(0, True)\nsync()\ntextmsg(get_tool_current())\n");
    assertEquals(0.08 + 0.025 + 0.05, number("tool_output_current"), 1e-12);
    assertEquals("0.155", robot.said().getLast());
    robot.run("set_tool_output_mode(1)\n");
    assertEquals(0.08 + 0.025 + 0.1, number("tool_output_current"), 1e-12);
    assertEquals(24, integer("tool_output_voltage"));
  }

  @Test
  void theTcpMovesAsTheProgramAsks() {
    robot.run("set_tcp(p[0, 0, 0.1, 0, 0, 0])\n" + STRETCHED);
    robot.start("speedl([0, 0.1, 0.05, 0, 0, 0.2], 1, 2)\n");
    robot.advance(300);
    assertEquals(0.1, element("target_TCP_speed", 1), 1e-6);
    assertEquals(0.05, element("target_TCP_speed", 2), 1e-6);
    assertEquals(0.2, element("target_TCP_speed", 5), 1e-6);
    assertEquals(0.1, element("actual_TCP_speed", 1), 1e-3);
    assertEquals(0, element("target_TCP_acceleration", 1), 1e-3);
    assertEquals(0.1, element("tcp_offset", 2));
    double momentum = number("actual_momentum");
    assertTrue(momentum > 0.1 && momentum < 5, "momentum is " + momentum);
  }

  @Test
  void theElbowIsAnUpperArmAwayFromTheShoulder() {
    robot.run(STRETCHED);
    double x = element3("elbow_position", 0);
    double y = element3("elbow_position", 1);
    double z = element3("elbow_position", 2) - 0.1625;
    assertEquals(0.425, Math.sqrt(x * x + y * y + z * z), 1e-4);
  }

  @Test
  void aPushIsFeltByTheSensorAndInTheCurrents() {
    robot.run(STRETCHED + "set_payload(2, [0, 0, 0.1])\n");
    robot.advance(1000);
    double rawBefore = element("ft_raw_wrench", 2);
    robot.done(new WorldCommand.PushTool(new Wrench(0, 0, -20, 0, 0, 0)));
    robot.advance(500);
    assertEquals(-20, element("actual_TCP_force", 2), 0.1);
    assertEquals(20, number("tcp_force_scalar"), 0.1);
    // the flange looks downwards: its axis feels a push from above as a push outwards
    assertEquals(rawBefore + 20, element("ft_raw_wrench", 2), 0.1);
    assertEquals(2 * 9.82, rawBefore, 0.5);
    // friction hides as much of it as it is
    assertEquals(-20, element("wrench_calc_from_currents", 2), 15);
    double ratio = number("collision_detection_ratio");
    assertTrue(ratio > 0.1 && ratio < 1, "ratio is " + ratio);
  }

  @Test
  void theBaseCarriesTheArm() {
    robot.run(STRETCHED + "set_gravity([0, 0, 9.82])\nset_payload(3)\n");
    double massKg =
        robot.state().arm().description().links().stream().mapToDouble(l -> l.massKg()).sum();
    assertEquals((massKg + 3) * 9.82, element("target_base_wrench", 2), 1e-6);
  }

  @Test
  void energyIsTakenAtRestAndMoreInMotion() {
    robot.run(STRETCHED);
    robot.advance(500);
    double rest = number("actual_robot_current");
    double before = number("actual_robot_energy_consumed");
    robot.advance(500);
    double inASecond = number("actual_robot_energy_consumed") - before;
    assertEquals(48 * rest, inASecond, 0.01 * inASecond);
    robot.start("movej([0, -0.5, -1.5708, -1.5708, 1.5708, 0], a=3, v=1)\n");
    robot.advance(150);
    assertTrue(number("actual_robot_current") > rest + 0.1, "takes no more to lift the arm");
    assertTrue(number("actual_robot_voltage") < 48, "no wire takes any voltage");
  }

  @Test
  void brakingGivesEnergyBack() {
    robot.run("movej([0, -1.5708, 0, 0, 0, 0])\n");
    double before = number("actual_robot_braking_energy_dissipated");
    robot.run("movej([0, -0.5, 0, 0, 0, 0], a=8, v=3)\n");
    assertTrue(number("actual_robot_braking_energy_dissipated") > before + 1, "none is dissipated");
  }

  @Test
  void currentsBelongToTorques() {
    robot.run(STRETCHED);
    robot.advance(500);
    double constant = robot.state().arm().description().actuators().get(1).torqueConstantNmPerA();
    assertEquals(
        element("actual_current_as_torque", 1), constant * element("actual_current", 1), 1e-9);
    assertEquals(element("target_moment", 1), constant * element("target_current", 1), 1e-9);
    assertTrue(Math.abs(element("target_moment", 1)) > 10, "the shoulder carries nothing");
    assertTrue(element("actual_current_window", 1) > 1, "no current is allowed");
  }

  @Test
  void ratiosAndExecutionTimesAreReproducible() {
    robot.run(STRETCHED);
    assertEquals(0, number("actual_execution_time"));
    assertEquals(2, number("target_execution_time"), 1e-9);
    assertEquals(robot.state().frame(), longBits("control_step"));
    assertEquals(0.002 * robot.state().frame(), number("timestamp"), 1e-9);
    robot.start("movej([1, -1, -1, -1, 1, 1])\n");
    robot.advance(100);
    double ratio = number("joint_position_deviation_ratio");
    assertTrue(ratio > 0 && ratio < 0.1, "ratio is " + ratio);
  }

  @Test
  void theExecutionTimeIsMeasuredWhenTheClockOfTheWallCounts() {
    Controller real =
        new Controller(ControllerOptions.headless().withSystemTime(InstantSource.system()));
    real.advance();
    assertTrue(real.state().executionTimeS() > 0, "no time has passed");
  }

  @Test
  void timeIsScaledByPausesAndNotByTheSlider() {
    robot.done(new BoxCommand.SetSpeedFraction(0.5));
    robot.start("movej([1, -1, -1, -1, 1, 1])\n");
    robot.advance(200);
    assertEquals(0.5, number("speed_scaling"));
    assertEquals(0.5, number("target_speed_fraction"));
    assertEquals(0, integer("time_scale_source"));
    robot.done(new ProgramCommand.PauseProgram());
    robot.advance(100);
    assertEquals(0, number("speed_scaling"));
    assertEquals(1, integer("time_scale_source"));
  }

  @Test
  void theSpeedIsScaledOnlyWhileAProgramRuns() {
    robot.advance(10);
    assertEquals(0, number("speed_scaling"));
    assertEquals(1, number("target_speed_fraction"));
    robot.start("sleep(1)\n");
    robot.advance(10);
    assertEquals(1, number("speed_scaling"));
    robot.done(new ProgramCommand.PauseProgram());
    robot.advance(100);
    assertEquals(0, number("speed_scaling"));
    assertEquals(1, number("target_speed_fraction"));
  }

  @Test
  void theOutputOfTheControllerIsTheTargetCurrent() {
    robot.start("movej([1, -1, -1, -1, 1, 1])\n");
    robot.advance(200);
    assertEquals(element("target_current", 2), element("joint_control_output", 2));
  }

  @Test
  void encodersCount() {
    robot.done(new WorldCommand.RunEncoder(1, 1000));
    robot.advance(500);
    assertEquals(0, integer("encoder0_raw"));
    assertEquals(1000, integer("encoder1_raw"), 5);
  }

  @Test
  void posesAreThoseOfTheScriptFunctions() {
    robot.run(STRETCHED + "p1 = get_actual_tcp_pose()\ntextmsg(p1[0], \"\")\n");
    Pose pose = robot.state().arm().actualTcpInBase();
    for (int i = 0; i < Joints.COUNT; i++) {
      assertEquals(pose.get(i), element("actual_TCP_pose", i));
    }
    assertEquals(Double.parseDouble(robot.said().getLast()), element("actual_TCP_pose", 0), 1e-4);
  }

  @Test
  void theSpeedSliderIsItsOwnersAlone() {
    robot.done(new IoCommand.ClaimSignal("RTDE client", InputOwners.SPEED_SLIDER));
    assertEquals(
        new Reply.Refused(Refusal.Code.IN_USE, "speed_slider is in use by RTDE client"),
        robot.ask(new BoxCommand.SetSpeedFraction(0.5)));
    assertEquals(1, number("target_speed_fraction"));
    robot.done(new BoxCommand.SetSpeedFraction("RTDE client", 0.25));
    assertEquals(0.25, number("target_speed_fraction"));
    robot.done(new IoCommand.ReleaseSignals("RTDE client"));
    robot.done(new BoxCommand.SetSpeedFraction(0.5));
    assertEquals(0.5, number("target_speed_fraction"));
  }
}
