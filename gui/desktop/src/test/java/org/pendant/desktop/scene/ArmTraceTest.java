package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.recording.lines.FrameMargins;
import org.pendant.recording.lines.Margin;

final class ArmTraceTest {
  private final ControllerOptions options = ControllerOptions.headless();
  private final Controller controller = new Controller(options);
  private final ArmTrace trace = new ArmTrace(1000);

  private void run(String move) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                TestController.program(controller, "def prog():\n  " + move + "\nend\n")));
    FrameMargins margins = new FrameMargins(controller.state().arm(), options.safety());
    for (int i = 0; i < 300; i++) {
      controller.advance();
      margins.look(controller.state());
      trace.add(controller.state(), margins);
    }
  }

  private static double speed(TcpTrace trace) {
    return trace.speedMPerS(trace.size() / 2);
  }

  @Test
  void theElbowHasALineOfItsOwnByOneScaleOfSpeeds() {
    run("movej([1, -1.2, -1.6, -1.6, 1.6, 0], a=3, v=1)");
    TcpTrace both = trace.trace(true);
    TcpTrace elbow = both.elbow().orElseThrow();
    assertTrue(elbow.size() > 10, "points of the elbow: " + elbow.size());
    assertEquals(both.scaleMPerS(), elbow.scaleMPerS());
    double radiusM = Math.hypot(elbow.x(0), elbow.y(0));
    assertTrue(radiusM < 0.43, "an elbow of a UR5e is no farther from the base: " + radiusM);
    assertTrue(speed(elbow) < speed(both), "it is nearer to the base than the tool");
  }

  @Test
  void itIsThereOnlyWhereItIsWanted() {
    run("movej([1, -1.2, -1.6, -1.6, 1.6, 0], a=3, v=1)");
    assertEquals(Optional.empty(), trace.trace(false).elbow());
    assertSame(trace.trace(true), trace.trace(true));
    trace.clear();
    assertEquals(0, trace.trace(true).elbow().orElseThrow().size());
  }

  @Test
  void itIsColouredByTheSameMargin() {
    trace.colourBy(Optional.of(Margin.JOINT_SPEED));
    run("movej([1, -1.2, -1.6, -1.6, 1.6, 0], a=3, v=1)");
    TcpTrace elbow = trace.trace(true).elbow().orElseThrow();
    assertEquals(Optional.of(Margin.JOINT_SPEED), elbow.colouring());
  }
}
