package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.rtde.InputFields;
import org.pendant.controller.rtde.InputRecipe;
import org.pendant.controller.rtde.RtdeCommand;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.vm.ProgramState;

/** Programs and the RTDE clients that write for them. */
final class RtdeInputProgramTest {
  private static final String CLIENT = "RTDE client";
  private static final InputRecipe REGISTER = recipe("input_int_register_24");
  private static final InputRecipe SENSOR = recipe("external_force_torque");

  /** Gives way along z of the base and wants no force. */
  private static final String YIELD_Z =
      "force_mode(p[0, 0, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 0, 0], 2,"
          + " [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])\nsleep(60)\n";

  private final PressingArm pressing = new PressingArm();
  private final RunningProgram robot = pressing.running;

  private static InputRecipe recipe(String... names) {
    return new InputRecipe(
        Arrays.stream(names).map(name -> InputFields.of(name).orElseThrow()).toList());
  }

  private static Command integer(int value) {
    return new RtdeCommand.WriteInputs(
        CLIENT, REGISTER.decode(ByteBuffer.allocate(4).putInt(value).flip()));
  }

  private static Command wrench(double... values6) {
    ByteBuffer bytes = ByteBuffer.allocate(48);
    Arrays.stream(values6).forEach(bytes::putDouble);
    return new RtdeCommand.WriteInputs(CLIENT, SENSOR.decode(bytes.flip()));
  }

  /** Sends a reading every frame; says how far the TCP went along z of the base, m. */
  private double travelZ(int frames, double... reading6) {
    double before = pressing.target().z();
    for (int i = 0; i < frames; i++) {
      robot.done(wrench(reading6));
    }
    return pressing.target().z() - before;
  }

  @Test
  void aPackageIsWrittenInTheNextFrame() {
    robot.done(integer(77));
    assertEquals(77, robot.state().signals().inputs().integer(24));
  }

  @Test
  void aPackageWithAnInputOfSomebodyElseIsRefusedAsAWhole() {
    robot.done(new IoCommand.ClaimSignal("PLC", "input_integer_register[24]"));
    InputRecipe both = recipe("input_int_register_25", "input_int_register_24");
    assertEquals(
        new Reply.Refused(Refusal.Code.IN_USE, "input_integer_register[24] is in use by PLC"),
        robot.ask(
            new RtdeCommand.WriteInputs(
                CLIENT, both.decode(ByteBuffer.allocate(8).putInt(1).putInt(2).flip()))));
    assertEquals(0, robot.state().signals().inputs().integer(25));
  }

  @Test
  void inputsAreTakenTogetherOrNotAtAll() {
    robot.done(new IoCommand.ClaimSignal("PLC", "input_integer_register[24]"));
    List<Set<String>> answers = new ArrayList<>();
    InputRecipe both = recipe("input_int_register_25", "input_int_register_24");
    robot.done(new RtdeCommand.ClaimInputs(CLIENT, both, answers::add));
    robot.done(new RtdeCommand.ClaimInputs("other", recipe("input_int_register_25"), answers::add));
    robot.done(new IoCommand.ReleaseSignals("PLC"));
    robot.done(new IoCommand.ReleaseSignals("other"));
    robot.done(new RtdeCommand.ClaimInputs(CLIENT, both, answers::add));
    robot.done(new RtdeCommand.ClaimInputs(CLIENT, both, answers::add));
    assertEquals(List.of(Set.of("input_int_register_24"), Set.of(), Set.of(), Set.of()), answers);
    assertEquals(
        new Reply.Refused(Refusal.Code.IN_USE, "input_integer_register[25] is in use by " + CLIENT),
        robot.ask(new IoCommand.ClaimSignal("PLC", "input_integer_register[25]")));
  }

  @Test
  void theSpeedSliderMoves() {
    InputRecipe slider = recipe("speed_slider_mask", "speed_slider_fraction");
    ByteBuffer values = ByteBuffer.allocate(12).putInt(1).putDouble(0.25).flip();
    robot.done(new RtdeCommand.WriteInputs(CLIENT, slider.decode(values)));
    assertEquals(0.25, robot.state().arm().speedFraction());
  }

  @Test
  void aWatchdogPausesTheProgramWhenTheClientFallsSilent() {
    robot.start("rtde_set_watchdog(\"input_int_register_24\", 10)\nsleep(10)\n");
    for (int i = 0; i < 10; i++) {
      robot.done(integer(1));
      robot.advance(40);
    }
    assertEquals(ProgramState.RUNNING, robot.programState());
    robot.advance(12);
    assertEquals(ProgramState.PAUSED, robot.programState());
    assertEquals(
        List.of(
            "RTDE input input_int_register_24 must be written at least at 10 Hz and was not: the"
                + " program pauses"),
        robot.reported());
  }

  @Test
  void aProgramThatGoesOnIsWatchedAgain() {
    robot.start("rtde_set_watchdog(\"input_int_register_24\", 10)\nsleep(10)\n");
    robot.advance(60);
    assertEquals(ProgramState.PAUSED, robot.programState());
    robot.advance(500);
    robot.done(new ProgramCommand.ResumeProgram());
    robot.advance(45);
    assertEquals(ProgramState.RUNNING, robot.programState());
    robot.advance(10);
    assertEquals(ProgramState.PAUSED, robot.programState());
  }

  @Test
  void aWatchdogMayStopTheProgramOrOnlySaySo() {
    robot.run("rtde_set_watchdog(\"input_int_register_24\", 10, \"stop\")\nsleep(10)\n");
    assertTrue(robot.reported().getFirst().endsWith("the program ends"));
    robot.run("rtde_set_watchdog(\"input_int_register_24\", 10, \"ignore\")\nsleep(1)\n");
    assertEquals(2, robot.reported().size());
    assertTrue(robot.reported().getLast().endsWith("the program continues"));
  }

  @Test
  void watchdogsEndWithTheProgram() {
    robot.run("rtde_set_watchdog(\"input_int_register_24\", 10)\n");
    robot.run("sleep(1)\n");
    assertEquals(List.of(), robot.reported());
  }

  @Test
  void theReadingsOfAnExternalSensorAreWatchedUnasked() {
    robot.start("ft_rtde_input_enable(True)\nsleep(10)\n");
    robot.advance(60);
    assertEquals(ProgramState.PAUSED, robot.programState());
    robot.done(new ProgramCommand.StopProgram());
    robot.run("ft_rtde_input_enable(True)\nft_rtde_input_enable(False)\nsleep(1)\n");
  }

  @Test
  void anotherWatchdogTakesThePlaceOfTheUnaskedOne() {
    robot.run(
        """
        rtde_set_watchdog("input_int_register_24", 0.1)
        ft_rtde_input_enable(True)
        sleep(1)
        """);
    assertEquals(List.of(), robot.reported());
  }

  @Test
  void forceModeGivesWayToWhatTheExternalSensorFeels() {
    pressing.start("ft_rtde_input_enable(True)\n" + YIELD_Z);
    // the flange looks down: its z is -z of the base
    assertTrue(travelZ(200, 0, 0, -10, 0, 0, 0) > 0.005);
    robot.done(new ProgramCommand.StopProgram());
    robot.advance(500);
    pressing.start("ft_rtde_input_enable(True)\nft_rtde_input_enable(False)\n" + YIELD_Z);
    assertEquals(0, travelZ(200, 0, 0, -10, 0, 0, 0), 1e-4);
  }

  @Test
  void theSensorFeelsThePayloadLessItself() {
    double weightN = 1.5 * ArmDynamics.STANDARD_GRAVITY_M_PER_S2;
    pressing.start(
        "set_target_payload(2, [0, 0, 0.1])\nsleep(0.1)\n"
            + "ft_rtde_input_enable(True, 0.5, [0, 0, 0], [0, 0, 0.05])\n"
            + YIELD_Z);
    assertEquals(0, travelZ(250, 0, 0, weightN, 0, 0, 0), 1e-4);
    assertTrue(travelZ(250, 0, 0, 0, 0, 0, 0) > 0.005);
  }

  @Test
  void theDeprecatedFunctionTurnsTheLeverRound() {
    assertTrue(turned("ft_rtde_input_enable") * turned("enable_external_ft_sensor") < -1e-4);
    assertTrue(turned("ft_rtde_input_enable") < 0);
  }

  /** How far a force along y of the flange, measured below it, turns the flange about its x. */
  private static double turned(String enable) {
    PressingArm arm = new PressingArm();
    arm.running.start(
        enable
            + "(True, 0, [0, 0, 0.3])\n"
            + "force_mode(get_target_tcp_pose(), [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 0, 0], 2,"
            + " [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])\nsleep(60)\n");
    Pose before = arm.target();
    for (int i = 0; i < 200; i++) {
      arm.running.done(wrench(0, 10, 0, 0, 0, 0));
    }
    return Poses.trans(Poses.inverse(before), arm.target()).rx();
  }

  @Test
  void aGuidedArmFollowsWhatTheExternalSensorFeels() {
    robot.start("ft_rtde_input_enable(True)\nfreedrive_mode()\nsleep(60)\n");
    robot.advance(20);
    double before = pressing.arm().actualTcpInBase().z();
    for (int i = 0; i < 500; i++) {
      robot.done(wrench(0, 0, -30, 0, 0, 0));
    }
    assertTrue(pressing.arm().actualTcpInBase().z() - before > 0.01);
  }
}
