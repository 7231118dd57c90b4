package org.pendant.desktop.log;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.safety.SafetyCommand;

final class StateChangesTest {
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final StateChanges changes = new StateChanges();
  private final List<String> told = new ArrayList<>();

  @BeforeEach
  void start() {
    advance(1);
    assertEquals(List.of(), told);
  }

  private void advance(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
      told.addAll(changes.in(controller.state()));
    }
  }

  private void run(String script) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, script)));
  }

  @Test
  void aProgramStartsPausesResumesAndFinishes() {
    run("def short():\n  sleep(0.1)\nend\n");
    advance(10);
    var _ = controller.submit(new ProgramCommand.PauseProgram());
    advance(100);
    var _ = controller.submit(new ProgramCommand.ResumeProgram());
    advance(100);
    assertEquals(
        List.of(
            "Program short started",
            "Program short paused",
            "Program short resumed after 0.200 s",
            "Program short finished after 0.100 s"),
        told);
  }

  @Test
  void aProgramOfASingleFrameStartsAndFinishes() {
    run("def at_once():\n  x = 1\nend\n");
    advance(5);
    assertEquals(
        List.of("Program at_once started", "Program at_once finished after 0.000 s"), told);
  }

  @Test
  void aProgramThatEndsOtherwiseSaysHow() {
    run("def wrong():\n  sleep(0.01)\n  x = 1 / 0\nend\n");
    advance(20);
    assertEquals("Program wrong failed after 0.010 s", told.getLast());
    run("def stopped():\n  sleep(10)\nend\n");
    advance(11);
    var _ = controller.submit(new ProgramCommand.StopProgram());
    advance(5);
    assertEquals("Program stopped stopped after 0.022 s", told.getLast());
    run("def halted():\n  halt\nend\n");
    advance(5);
    assertEquals("Program halted halted after 0.000 s", told.getLast());
  }

  @Test
  void powerAndBrakesAreTold() {
    var _ = controller.submit(new SafetyCommand.PowerOff());
    advance(5);
    assertEquals("Robot mode: power off, was running", told.getLast());
  }

  @Test
  void aSnapshotThatIsSeenTwiceIsToldOnce() {
    run("def short():\n  sleep(0.1)\nend\n");
    advance(1);
    assertEquals(List.of(), changes.in(controller.state()));
    assertEquals(List.of("Program short started"), told);
  }

  @Test
  void anotherControllerBeginsAnew() {
    run("def short():\n  sleep(0.1)\nend\n");
    advance(20);
    told.clear();
    Controller other = new Controller(ControllerOptions.headless());
    other.advance();
    assertEquals(List.of(), changes.in(other.state()));
    other.advance();
    assertEquals(List.of(), changes.in(other.state()));
  }
}
