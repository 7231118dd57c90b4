package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.state.RuntimeState;
import org.pendant.models.arm.Joints;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramState;

/** A program that a client sends takes the place of the one that runs. */
final class ReplacedProgramTest {
  private static final double FRAME_S = 0.002;
  private static final String STRETCHED = "movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0])\n";

  private final RunningProgram robot = new RunningProgram();

  private void upload(String text) {
    robot.done(new ProgramCommand.ReplaceProgram(robot.program(text)));
  }

  private double fastest() {
    return robot.state().arm().targetSpeedRadPerS().maxAbsDifference(Joints.ZERO);
  }

  private Ending ending() {
    return robot.state().program().ending().orElseThrow();
  }

  private String failure() {
    return assertInstanceOf(Ending.Failed.class, ending()).failure().message();
  }

  @Test
  void endsTheProgramThatRunsAndStartsInTheSameFrame() {
    robot.start("def old():\n  sleep(100)\nend\n");
    upload("def fresh():\n  textmsg(\"here\")\n  sleep(1)\nend\n");
    assertEquals(
        List.of(
            new ProgramEvent.Ended("old", new Ending.Stopped()), new ProgramEvent.Started("fresh")),
        robot.state().newProgramEvents());
    assertEquals(List.of("here"), robot.said());
    assertEquals("fresh", robot.state().program().name());
    assertEquals(RuntimeState.PLAYING, robot.state().program().runtime());
  }

  @Test
  void replacesAPausedProgramAsWell() {
    robot.start("def old():\n  sleep(100)\nend\n");
    robot.done(new ProgramCommand.PauseProgram());
    upload("textmsg(1)\n");
    robot.finish();
    assertEquals(List.of("1"), robot.said());
    assertEquals(ProgramState.STOPPED, robot.programState());
  }

  @Test
  void replacesAProgramThatADebuggerHolds() {
    robot.start("def old():\n  while True:\n    sync()\n  end\nend\n");
    robot.done(new DebugCommand.Debug(Debugger::pause));
    long frame = robot.state().frame();
    robot.advance(3);
    assertEquals(frame, robot.state().frame());
    upload("textmsg(1)\nsleep(0.1)\ntextmsg(2)\n");
    robot.advance(100);
    assertEquals(List.of("1", "2"), robot.said());
    assertEquals(ProgramState.STOPPED, robot.programState());
  }

  @Test
  void aProgramThatEndsAtOnceStillStartsAndEnds() {
    upload("def brief():\nend\n");
    assertEquals(
        List.of(
            new ProgramEvent.Started("brief"),
            new ProgramEvent.Ended("brief", new Ending.Finished())),
        robot.state().newProgramEvents());
  }

  @ParameterizedTest
  @ValueSource(ints = {4, 10, 50})
  void speedsThatAreSentAgainAndAgainMoveTheArmEvenly(int everyFrames) {
    robot.run(STRETCHED);
    robot.advance(50);
    upload("speedl([0, 0.1, 0.05, 0, 0, 0], 0.5, 1)\n");
    robot.advance(200);
    Joints before = robot.state().arm().targetSpeedRadPerS();
    for (int i = 0; i < 5 * everyFrames; i++) {
      if (i % everyFrames == 0) {
        upload("speedl([0, 0.1, 0.05, 0, 0, 0], 0.5, 1)\n");
      } else {
        robot.advance(1);
      }
      Joints now = robot.state().arm().targetSpeedRadPerS();
      assertEquals(0, now.maxAbsDifference(before) / FRAME_S, 0.5, "frame " + i);
      double speed = robot.state().geometry().target().speed().y();
      assertEquals(0.1, speed, 1e-3, "frame " + i);
      before = now;
    }
  }

  @Test
  void speedsThatChangeAndComeLateNeverJump() {
    robot.run(STRETCHED);
    robot.advance(50);
    SplittableRandom random = new SplittableRandom(61);
    Joints before = robot.state().arm().targetSpeedRadPerS();
    for (int i = 0; i < 3000; i++) {
      if (random.nextInt(20) == 0) {
        double vy = random.nextDouble(-0.2, 0.2);
        double turn = random.nextDouble(-0.5, 0.5);
        upload(
            random.nextBoolean()
                ? "speedl([0, " + vy + ", 0, 0, 0, 0], 1, 0.05)\n"
                : "speedj([" + turn + ", 0, 0, 0, 0, " + turn + "], 2, 0.05)\n");
      } else {
        robot.advance(1);
      }
      Joints now = robot.state().arm().targetSpeedRadPerS();
      double change = now.maxAbsDifference(before) / FRAME_S;
      assertTrue(change < 20, "frame " + i + " changes by " + change + " rad/s2");
      before = now;
    }
  }

  @Test
  void aStopTakesTheMovingArmOverFromItsPresentSpeed() {
    robot.start("movej([1, -1, -1, -1, 1, 1], a=3, v=1)\n");
    robot.advance(250);
    double before = fastest();
    upload("stopj(2)\n");
    assertEquals(before - 2 * FRAME_S, fastest(), 1e-3);
    robot.finish();
    assertEquals(0, fastest());
    assertInstanceOf(Ending.Finished.class, ending());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "movej([1, -1, -1, -1, 1, 1], a=3, v=1)\n",
        "movej([1, -1, -1, -1, 1, 1], a=3, v=1, r=0.1)\nmovej([0, -1, -1, -1, 1, 1])\n",
        "speedj([0.5, 0, 0, 0, 0, 0.3], 2, 10)\n",
        "while True:\n speedj([0.5, 0, 0, 0, 0, 0.3], 2, 0.002)\nend\n",
        "while True:\n direct_torque([3, 0, 0, 0, 0, 0])\nend\n",
        "freedrive_mode()\nsleep(10)\n"
      })
  void aMoveWaitsUntilTheArmHasComeToRest(String old) {
    robot.start(old);
    robot.advance(250);
    upload("movej([0.5, -1.2, -1.2, -1, 1, 0.5])\ntextmsg(\"there\")\n");
    robot.finish();
    assertEquals(List.of("there"), robot.said(), () -> robot.reported().toString());
    Joints goal = new Joints(0.5, -1.2, -1.2, -1, 1, 0.5);
    assertEquals(0, robot.state().arm().targetPositionRad().maxAbsDifference(goal), 1e-12);
  }

  @Test
  void theArmSlowsDownBy8RadPerS2BeforeAMoveThatWaits() {
    robot.start("movej([1, -1, -1, -1, 1, 1], a=3, v=1)\n");
    robot.advance(250);
    upload("movej([0.5, -1.2, -1.2, -1, 1, 0.5])\n");
    List<Double> speeds = new ArrayList<>();
    while (fastest() > 0) {
      speeds.add(fastest());
      robot.advance(1);
    }
    assertEquals(8, (speeds.get(10) - speeds.get(40)) / (30 * FRAME_S), 0.2);
  }

  @Test
  void withoutPowerStatementsRunUpToTheFirstMotion() {
    RunningProgram off = new RunningProgram(ControllerOptions.headless().withPower(false));
    off.done(
        new ProgramCommand.ReplaceProgram(
            off.program(
                "set_digital_out(1, True)\ntextmsg(1)\nmovej([0,0,0,0,0,0])\ntextmsg(2)\n")));
    off.finish();
    assertEquals(List.of("1"), off.said());
    assertEquals(2, off.state().io().standardOut());
    Ending.Failed failed =
        assertInstanceOf(Ending.Failed.class, off.state().program().ending().orElseThrow());
    assertEquals(
        "movej: the arm is POWER_OFF, must be RUNNING: power it on and release its brakes first",
        failed.failure().message());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "movel(get_actual_tcp_pose())",
        "movep(get_actual_tcp_pose())",
        "movec(get_actual_tcp_pose(), get_actual_tcp_pose())",
        "optimovej([0, 0, 0, 0, 0, 0])",
        "speedj([0.1, 0, 0, 0, 0, 0], 1)",
        "speedl([0.1, 0, 0, 0, 0, 0], 1)",
        "servoj([0, 0, 0, 0, 0, 0])",
        "direct_torque([0, 0, 0, 0, 0, 0])",
        "force_mode(p[0,0,0,0,0,0], [0,0,1,0,0,0], [0,0,1,0,0,0], 2, [1,1,1,1,1,1])",
        "freedrive_mode()"
      })
  void everyMotionNeedsPower(String motion) {
    RunningProgram off = new RunningProgram(ControllerOptions.headless().withPower(false));
    off.done(new ProgramCommand.ReplaceProgram(off.program(motion + "\ntextmsg(\"moved\")\n")));
    off.finish();
    assertEquals(List.of(), off.said());
    Ending.Failed failed =
        assertInstanceOf(Ending.Failed.class, off.state().program().ending().orElseThrow());
    assertTrue(failed.failure().message().contains("POWER_OFF"), failed.failure().message());
  }

  @Test
  void aStopHasNothingToStopWithoutPower() {
    RunningProgram off = new RunningProgram(ControllerOptions.headless().withPower(false));
    off.done(new ProgramCommand.ReplaceProgram(off.program("stopj(2)\nstopl(1)\ntextmsg(1)\n")));
    off.finish();
    assertEquals(List.of("1"), off.said());
  }

  @Test
  void peopleStillCannotStartProgramsWithoutPower() {
    RunningProgram off = new RunningProgram(ControllerOptions.headless().withPower(false));
    assertEquals(
        new Reply.Refused(
            Refusal.Code.ARM_POWER,
            "the arm is POWER_OFF, must be RUNNING: power it on and release its brakes first"),
        off.ask(new ProgramCommand.StartProgram(off.program("textmsg(1)\n"))));
    off.done(
        new ProgramCommand.RunSecondary(
            off.program("sec s():\n  set_digital_out(0, True)\nend\n")));
    assertEquals(1, off.state().io().standardOut());
  }

  @Test
  void nothingIsTakenDuringAStopAndThePausedProgramStays() {
    robot.start("def old():\n  sleep(100)\nend\n");
    robot.ask(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    assertEquals(ProgramState.PAUSED, robot.programState());
    assertInstanceOf(
        Reply.Refused.class,
        robot.ask(new ProgramCommand.ReplaceProgram(robot.program("textmsg(1)\n"))));
    assertInstanceOf(
        Reply.Refused.class,
        robot.ask(new ProgramCommand.RunSecondary(robot.program("sec s():\n  textmsg(2)\nend\n"))));
    assertEquals("old", robot.state().program().name());
    assertEquals(ProgramState.PAUSED, robot.programState());
    assertEquals(List.of(), robot.said());
  }

  @Test
  void aFailureOfTheNewProgramIsItsOwn() {
    robot.start("def old():\n  sleep(100)\nend\n");
    upload("def fresh():\n  x = 1 / 0\nend\n");
    assertTrue(failure().contains("0"), failure());
    assertEquals("fresh", robot.state().program().name());
  }
}
