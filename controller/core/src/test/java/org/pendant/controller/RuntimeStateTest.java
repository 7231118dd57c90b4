package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.state.RuntimeState;

/** What interfaces say of program and arm together. */
final class RuntimeStateTest {
  private static final String MOVE = "movej([1, -1, -1, -1, 1, 1], a=3, v=1)\n";

  private final RunningProgram robot = new RunningProgram();
  private final List<RuntimeState> seen = new ArrayList<>(List.of(now()));

  private RuntimeState now() {
    return robot.state().program().runtime();
  }

  /** Notes each change of the state. */
  private void advance(int frames) {
    look();
    for (int i = 0; i < frames; i++) {
      robot.advance(1);
      look();
    }
  }

  private void look() {
    if (seen.getLast() != now()) {
      seen.add(now());
    }
  }

  @Test
  void aProgramThatEndsByItselfPlaysAndHasStopped() {
    robot.start("sleep(0.1)\n");
    advance(100);
    assertEquals(List.of(RuntimeState.STOPPED, RuntimeState.PLAYING, RuntimeState.STOPPED), seen);
  }

  @Test
  void aStoppedProgramIsStoppingUntilTheArmRests() {
    robot.start(MOVE);
    advance(250);
    robot.done(new ProgramCommand.StopProgram());
    assertEquals(RuntimeState.STOPPING, now());
    advance(300);
    assertEquals(
        List.of(
            RuntimeState.STOPPED,
            RuntimeState.PLAYING,
            RuntimeState.STOPPING,
            RuntimeState.STOPPED),
        seen);
  }

  @Test
  void aPauseIsOnItsWayUntilTheArmRestsAndItsEndUntilTheArmIsAsFastAsBefore() {
    robot.start(MOVE);
    advance(250);
    double scaling = robot.state().arm().speedScaling();
    robot.done(new ProgramCommand.PauseProgram());
    assertEquals(RuntimeState.PAUSING, now());
    advance(300);
    assertEquals(RuntimeState.PAUSED, now());
    robot.done(new ProgramCommand.ResumeProgram());
    assertEquals(RuntimeState.RESUMING, now());
    while (now() == RuntimeState.RESUMING) {
      advance(1);
    }
    assertEquals(scaling, robot.state().arm().speedScaling());
    assertEquals(
        List.of(
            RuntimeState.STOPPED,
            RuntimeState.PLAYING,
            RuntimeState.PAUSING,
            RuntimeState.PAUSED,
            RuntimeState.RESUMING,
            RuntimeState.PLAYING),
        seen);
  }

  @Test
  void aProgramWithoutMotionIsPausedAtOnce() {
    robot.start("sleep(1)\n");
    robot.done(new ProgramCommand.PauseProgram());
    assertEquals(RuntimeState.PAUSED, now());
    robot.done(new ProgramCommand.ResumeProgram());
    assertEquals(RuntimeState.RESUMING, now());
    robot.advance(1);
    assertEquals(RuntimeState.PLAYING, now());
  }

  @Test
  void anArmThatIsJoggedStopsNoProgram() {
    robot.done(new ManualCommand.Jog(new JogMove.TurnJoint(0, 1), 0.5));
    advance(50);
    assertEquals(List.of(RuntimeState.STOPPED), seen);
  }
}
