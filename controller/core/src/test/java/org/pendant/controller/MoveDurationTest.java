package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.language.source.Source;
import org.pendant.models.arm.Joints;
import org.pendant.script.vm.ProgramState;

/**
 * Durations of moves of joints against those measured on a UR10e at 40 °/s and 50 °/s², in
 * recordings of shamilmamedov/dynamic_calibration, commit 11af40e7, folder dataset_ur10e.
 */
class MoveDurationTest {
  private static final int MAX_FRAMES = 10_000;

  /** The recordings have a sample every 10 ms. */
  private static final double TOLERANCE_S = 0.010;

  @ParameterizedTest
  @CsvSource({
    "'-0.5147, -2.1269, 1.8953, -0.1240, -0.2311, -2.5077',"
        + "'0.4701, -0.9532, 0.8807, -0.2062, -0.2537, -1.6125', 2.472",
    "'-0.3425, -1.9966, -1.3592, -2.2389, 1.2116, -2.5312',"
        + "'1.1755, -0.9235, -1.8872, -1.3064, 2.9482, -2.5312', 3.287",
    "'0.1814, -0.2123, 0.3615, -1.6757, 4.9308, -2.5315',"
        + "'-0.1130, -0.9857, -2.2192, -2.3224, 6.2341, -2.5309', 4.498",
    "'-0.9373, -2.5548, 2.2131, -1.2305, 4.7275, -4.1073',"
        + "'0.3401, -2.8151, 0.4665, -3.9039, 4.7263, -4.1076', 4.624",
    "'0.2417, -2.5840, -1.5109, -2.9025, 6.1039, -4.1077',"
        + "'-1.1452, -1.8032, -1.2342, -0.1983, 1.7764, -2.6065', 6.996",
  })
  void takeAsLongAsOnARealArm(String start, String goal, double measuredS) {
    double[] q = new double[Joints.COUNT];
    String[] numbers = start.split(",", -1);
    for (int i = 0; i < q.length; i++) {
      q[i] = Double.parseDouble(numbers[i]);
    }
    // the moves were not the first of their programs
    String program =
        String.format(
            Locale.ROOT,
            """
            def move():
              sleep(0.5)
              movej([%s], a=%.10f, v=%.10f)
            end
            """,
            goal,
            Math.toRadians(50),
            Math.toRadians(40));

    assertEquals(measuredS, durationS(Joints.of(q), program), TOLERANCE_S);
  }

  /** The time in which targets move. */
  private static double durationS(Joints start, String program) {
    Controller controller =
        new Controller(ControllerOptions.headless().withRobot("ur10e").withStart(start));
    var reply =
        controller.submit(
            new ProgramCommand.StartProgram(
                controller.load(Source.of("move.script", program)).program().orElseThrow(),
                Optional.empty()));
    controller.advance();
    assertEquals(Optional.empty(), reply.join().complaint());
    int moving = 0;
    for (int i = 0; i < MAX_FRAMES; i++) {
      if (controller.state().program().state() == ProgramState.STOPPED) {
        return moving * 0.002;
      }
      controller.advance();
      if (controller.state().arm().targetSpeedRadPerS().maxAbsDifference(Joints.ZERO) > 0) {
        moving++;
      }
    }
    throw new AssertionError("the program did not end within " + MAX_FRAMES + " frames");
  }
}
