package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Command;

final class RunClockTest {
  private static final double FRAME_S = 0.002;

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final RunClock clock = new RunClock();

  private void frames(int count) {
    for (int i = 0; i < count; i++) {
      controller.advance();
      clock.frame(controller.state());
    }
  }

  private void send(Command command) {
    var _ = controller.submit(command);
    frames(1);
  }

  private void start(String text) {
    send(new ProgramCommand.StartProgram(TestController.program(controller, text)));
  }

  private double ranS() {
    return clock.time().ranS(controller.state().timeS());
  }

  private double pausedS() {
    return clock.time().pausedS(controller.state().timeS());
  }

  @Test
  void beforeTheFirstProgramThereIsNothingToTell() {
    frames(5);
    assertFalse(clock.time().known());
    assertEquals(0, ranS());
  }

  @Test
  void theTimeStandsWhenTheProgramEnds() {
    start("sleep(2)\n");
    frames(750);
    assertEquals(1.5, ranS(), FRAME_S);
    frames(500);
    double endS = ranS();
    assertEquals(2, endS, 2 * FRAME_S);
    frames(500);
    assertEquals(endS, ranS());
  }

  @Test
  void aPauseStopsTheTimeAndIsTakenApart() {
    start("sleep(2)\n");
    frames(500);
    send(new ProgramCommand.PauseProgram());
    double ranS = ranS();
    frames(1500);
    assertEquals(ranS, ranS(), 1e-9);
    assertEquals(3, pausedS(), FRAME_S);
    send(new ProgramCommand.ResumeProgram());
    frames(250);
    assertEquals(1.5, ranS(), 3 * FRAME_S);
    assertEquals(3, pausedS(), 2 * FRAME_S);
    send(new ProgramCommand.StopProgram());
    frames(100);
    assertEquals(1.5, ranS(), 4 * FRAME_S);
    assertEquals(3, pausedS(), 2 * FRAME_S);
  }

  @Test
  void aProgramThatEndsInTheFrameOfItsStartHasATimeOfItsOwn() {
    start("sleep(1)\n");
    frames(600);
    start("x = 1\n");
    frames(2);
    assertEquals(0, ranS(), FRAME_S);
    assertTrue(clock.time().known());
  }

  @Test
  void aControllerThatStandsEarlierInTheSameRunHasItsTime() {
    start("sleep(5)\n");
    frames(100);
    var earlier = controller.state();
    frames(500);
    clock.goBack(earlier);
    assertEquals(0.2, clock.time().ranS(earlier.timeS()), FRAME_S);
  }

  @Test
  void anotherControllerHasRunNothing() {
    start("sleep(1)\n");
    frames(600);
    clock.goBack(new Controller(ControllerOptions.headless()).state());
    assertFalse(clock.time().known());
  }
}
