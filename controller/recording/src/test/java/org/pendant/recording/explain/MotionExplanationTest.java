package org.pendant.recording.explain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.safety.SpeedUse;
import org.pendant.recording.RecordingRing;
import org.pendant.recording.explain.Cause.Kind;

/** What set the speed of an arm whose program and limits are known. */
final class MotionExplanationTest {
  private static final String HOME = "movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=1)\n";

  private final ControllerOptions options = ControllerOptions.headless().withArm(ArmChoice.IDEAL);
  private final Controller controller = new Controller(options);
  private final RecordingRing ring =
      new RecordingRing(controller.state(), controller::programSource);
  private long started;

  private void run(String text, int frames) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, text)));
    advance(1);
    started = controller.state().frame();
    advance(frames);
  }

  private void advance(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
      ring.take(controller.state());
    }
  }

  private MotionExplanation at(double sinceStartS) {
    return MotionExplanation.of(
        ring.recording(), started + Math.round(sinceStartS * 500), options.safety(), false);
  }

  private static String moveDown(String how) {
    return HOME + "movel(pose_add(get_target_tcp_pose(), p[0, 0, -0.3, 0, 0, 0]), " + how + ")\n";
  }

  @Test
  void aMoveAtItsFullSpeedGoesAtThatOfTheCommand() {
    run(moveDown("a=1, v=0.1"), 2500);

    MotionExplanation cruise = at(2.5);
    assertEquals(Kind.COMMAND_SPEED, cruise.cause().kind());
    assertTrue(cruise.cause().certain(), "the line says so");
    assertEquals(0.1, cruise.cause().value(), 1e-6);
    assertEquals(0.1, cruise.plannedSpeedMPerS(), 1e-6);
    assertEquals(2, cruise.now().program().line());
    assertTrue(cruise.text().startsWith("movel("), cruise.text());
  }

  @Test
  void aMoveThatBeginsSpeedsUpAndOneThatEndsSlowsDown() {
    run(moveDown("a=0.1, v=0.1"), 2500);

    assertEquals(Kind.ACCELERATION, at(1.5).cause().kind());
    assertEquals(0.1, at(1.5).cause().value(), 0.001);
    assertEquals(Kind.DECELERATION, at(4.6).cause().kind());
  }

  @Test
  void whatFramesSayIsCertain() {
    run(moveDown("a=0.1, v=0.1"), 2500);

    assertTrue(at(1.5).cause().certain(), "the speed grows");
    assertTrue(at(1.5).cause().asTheCommandSays(), "as much as the line says");
    assertTrue(at(4.6).cause().certain(), "the speed falls");
  }

  @Test
  void aWayThatIsTooShortForTheSpeedIsKnownByTheFramesAroundIt() {
    run(moveDown("a=1, v=5"), 2500);

    long peak = 0;
    double fastest = 0;
    for (int i = 500; i < 1500; i++) {
      double speed = at(i / 500.0).plannedSpeedMPerS();
      if (speed > fastest) {
        fastest = speed;
        peak = i;
      }
    }
    Cause cause = at(peak / 500.0).cause();
    assertEquals(Kind.SHORT_WAY, cause.kind());
    assertTrue(cause.certain(), "it slows down right after");
    assertEquals(5, cause.asked());
  }

  @Test
  void aMoveThatIsToTakeATimeHasTheSpeedForThat() {
    run(moveDown("t=3"), 2500);
    boolean steady = false;
    for (int i = 600; i < 2000; i += 10) {
      Cause cause = at(i / 500.0).cause();
      assertTrue(cause.certain(), () -> cause.toString());
      steady |= cause.kind() == Kind.COMMAND_TIME;
    }
    assertTrue(steady, "some of it goes at one speed");
  }

  @Test
  void aProgramThatSetsSpeedsItselfIsSaidToDoSo() {
    run("speedj([0.2, 0, 0, 0, 0, 0], 5, 3)\n", 1000);
    assertEquals(Kind.STREAMED, at(1).cause().kind());
  }

  @Test
  void aJointThatTurnsAsFastAsItCanIsNamed() {
    run(HOME + "movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 5], a=30, v=9)\n", 2000);
    Cause cause = at(1.8).cause();
    assertEquals(Kind.JOINT_LIMIT, cause.kind());
    assertTrue(cause.certain(), "the frame has the speed of the joint");
    assertEquals(5, cause.use().orElseThrow().joint());
    assertEquals(9, cause.asked());
  }

  @Test
  void theSliderIsTakenIntoAccount() {
    var _ = controller.submit(new BoxCommand.SetSpeedFraction(0.5));
    advance(200);
    run(moveDown("a=1, v=0.1"), 4000);

    MotionExplanation cruise = at(4);
    assertEquals(Kind.COMMAND_SPEED, cruise.cause().kind());
    assertEquals(0.1, cruise.cause().value(), 1e-6, "what the command asks for at full speed");
    assertEquals(0.05, cruise.plannedSpeedMPerS(), 1e-6);
  }

  @Test
  void aVariableOfTheProgramIsLookedUp() {
    run("FAST = 0.1\n" + moveDown("a=1, v=FAST"), 2500);

    assertEquals(Kind.COMMAND_SPEED, at(2.5).cause().kind());
    assertTrue(at(2.5).cause().certain(), "FAST is 0.1");
  }

  @Test
  void aLimitOfTheSafetyIsFoundWhereItSlowsTheArm() {
    run(
        """
        movej([0, -0.3, 0, -1.5708, 1.5708, 0], t=2)
        movej([2, -0.3, 0, -1.5708, 1.5708, 0], a=20, v=3)
        """,
        2500);

    MotionExplanation slowed = at(2.45);
    assertEquals(Kind.SAFETY_LIMIT, slowed.cause().kind());
    assertEquals(SpeedUse.Kind.TOOL_SPEED, slowed.cause().use().orElseThrow().kind());
    assertTrue(slowed.cause().certain(), "the scaling is below the slider");
    SpeedUse use = slowed.cause().use().orElseThrow();
    assertEquals(1, use.share(), 0.005);
  }

  @Test
  void anArmThatRestsIsSaidToRest() {
    run(HOME + "sleep(5)\n", 1000);
    assertEquals(Kind.REST, at(1.8).cause().kind());
  }

  @Test
  void aPauseSlowsTheArmDown() {
    run(moveDown("a=1, v=0.1"), 1000);
    var _ = controller.submit(new ProgramCommand.PauseProgram());
    advance(100);
    assertEquals(Kind.PAUSE, at(2.004).cause().kind());
  }

  @Test
  void aSliderThatMovesChangesTheSpeedInARamp() {
    run("movej([2, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=5, v=1)\n", 500);
    var _ = controller.submit(new BoxCommand.SetSpeedFraction(0.2));
    advance(500);
    assertEquals(Kind.SCALING_RAMP, at(1.02).cause().kind());
  }

  @Test
  void theStartRampIsToldWhereThereIsOne() {
    run("movej([2, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=5, v=1)\n", 500);
    assertEquals(
        Kind.START_RAMP,
        MotionExplanation.of(ring.recording(), started + 20, options.safety(), true)
            .cause()
            .kind());
  }
}
