package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.desktop.session.ArmReadiness.Light;

final class ArmReadinessTest {
  private final Controller controller =
      new Controller(ControllerOptions.headless().withPower(false));

  private ArmReadiness readiness() {
    return ArmReadiness.of(controller.state());
  }

  private ProgramControls controls() {
    return ProgramControls.of(controller.state());
  }

  private void send(Command command) {
    var reply = controller.submit(command);
    controller.advance();
    assertEquals(new Reply.Done(), reply.join());
  }

  private void switchOn() {
    send(readiness().command().orElseThrow());
    assertTrue(
        controller.runUntil(
            () -> controller.state().safety().robotMode() == RobotMode.RUNNING, 5000));
  }

  private void start(String text) {
    send(new ProgramCommand.StartProgram(TestController.program(controller, text)));
  }

  @Test
  void oneButtonPowersTheArmOnAndReleasesItsBrakes() {
    controller.advance();
    assertEquals(Light.OFF, readiness().light());
    assertEquals("Switch on", readiness().remedy());
    assertEquals("The arm is not ready: switch it on first", controls().whyNoRun());
    send(readiness().command().orElseThrow());
    assertEquals(Light.WAITING, readiness().light());
    assertEquals(Optional.empty(), readiness().command());
    controller.runUntil(() -> readiness().light() == Light.READY, 5000);
    assertEquals("Switch off", readiness().remedy());
    assertTrue(controls().canStart());
  }

  @Test
  void aProtectiveStopCountsDownToItsUnlocking() {
    switchOn();
    start("protective_stop()\nsleep(5)\n");
    controller.runUntil(() -> controller.state().safety().stop().isPresent(), 100);
    assertEquals("Unlock in 5 s", readiness().remedy());
    assertEquals(Optional.empty(), readiness().command());
    assertEquals("Not during protective stop", controls().whyNoRun());
    for (int i = 0; i < 1100; i++) {
      controller.advance();
    }
    assertEquals("Unlock in 3 s", readiness().remedy());
    controller.runUntil(() -> readiness().command().isPresent(), 3000);
    send(readiness().command().orElseThrow());
    assertEquals(Light.READY, readiness().light());
    assertTrue(controls().canResume());
  }

  @Test
  void anEmergencyStopLastsUntilItsInputIsReleased() {
    switchOn();
    send(new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true));
    controller.advance();
    assertEquals(Light.STOPPED, readiness().light());
    assertEquals("Robot emergency stop", readiness().text());
    assertEquals(Optional.empty(), readiness().command());
  }

  @Test
  void theButtonsFollowTheProgram() {
    switchOn();
    assertTrue(controls().canStart());
    assertFalse(controls().canStop());
    assertEquals("No program is running", controls().whyNoPause());
    start("sleep(5)\n");
    assertEquals("The program is running", controls().whyNoRun());
    assertTrue(controls().canPause() && controls().canStop());
    send(new ProgramCommand.PauseProgram());
    assertTrue(controls().canResume());
    assertFalse(controls().canStart());
    assertEquals("The program is paused already", controls().whyNoPause());
    assertEquals("", controls().whyNoStep());
  }
}
