package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.moveL;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.waypoint;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.TemplateStep.ConveyorTracking;
import org.pendant.project.program.TemplateStep.Force;
import org.pendant.project.program.TemplateStep.ForceKind;
import org.pendant.project.program.TemplateStep.Screwdriving;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.WaypointPosition;

/** Templates in which the arm gives way to something, or goes along with it. */
final class ProcessRunTest {
  private static final List<Boolean> ALONG_Z = List.of(false, false, true, false, false, false);
  private static final List<Double> LIMITS = List.of(0.1, 0.1, 0.1, 0.3, 0.3, 0.3);
  private static final int FRAMES_PER_S = 500;

  private static ProgramNode force(
      ForceKind kind, String feature, double forceN, ProgramNode... children) {
    return node(
        new Force(kind, feature, ALONG_Z, List.of(0.0, 0.0, forceN, 0.0, 0.0, 0.0), LIMITS),
        children);
  }

  @ParameterizedTest
  @EnumSource(names = {"SIMPLE", "FRAME"})
  void theToolPressesWhileTheChildrenRun(ForceKind kind) {
    ArmRun run =
        new ArmRun(
            program(force(kind, WaypointPosition.BASE, -20, sleep(4)), say("ended"), sleep(1)),
            ArmRun.table(0.01));
    run.advance(4 * FRAMES_PER_S - 50);
    assertEquals(20, run.pressN(), 1);
    run.until("ended").finish();
    assertTrue(Math.abs(run.moved().x()) < 1e-4 && Math.abs(run.moved().y()) < 1e-4, run::toString);
  }

  @Test
  void aForceTowardsAPointIsAlongTheLineFromTheTool() {
    Feature below =
        new Feature(
            "below",
            FeatureKind.POINT,
            List.of(new Pose(ArmRun.HERE.x(), ArmRun.HERE.y(), -1, 0, 0, 0)),
            false,
            true);
    List<Boolean> alongY = List.of(false, true, false, false, false, false);
    ArmRun run =
        new ArmRun(
            program(
                node(
                    new Force(
                        ForceKind.POINT,
                        "below",
                        alongY,
                        List.of(0.0, 20.0, 0.0, 0.0, 0.0, 0.0),
                        LIMITS),
                    sleep(4))),
            ArmRun.installation(List.of(below), List.of()),
            ArmRun.table(0.01));
    run.advance(4 * FRAMES_PER_S - 50);
    assertEquals(20, run.pressN(), 1);
    run.finish();
  }

  @Test
  void aForceByTheMotionActsWhileTheToolMoves() {
    ArmRun run =
        new ArmRun(
            program(
                    force(
                        ForceKind.MOTION,
                        WaypointPosition.BASE,
                        -20,
                        moveL(waypoint("beside")),
                        say("beside")))
                .withWaypoint("beside", ArmRun.place(0, 0.2, 0)),
            ArmRun.table(0.01));
    double[] most = new double[1];
    while (run.running()) {
      run.advance(1);
      most[0] = Math.max(most[0], run.pressN());
    }
    run.finish();
    assertTrue(most[0] > 15, () -> most[0] + " N in " + run);
    assertEquals(0.2, run.moved().y(), 2e-3);
  }

  @Test
  void aSimpleForceIsAlongTheToolIfThatIsTheFeature() {
    ArmRun run =
        new ArmRun(
            program(force(ForceKind.SIMPLE, WaypointPosition.TOOL, 20, sleep(4))),
            ArmRun.table(0.01));
    run.advance(4 * FRAMES_PER_S - 50);
    assertEquals(20, run.pressN(), 1);
    run.finish();
  }

  @Test
  void theToolSlidesOverTheTableWhileItPresses() {
    ArmRun run =
        new ArmRun(
            program(
                    force(
                        ForceKind.FRAME,
                        WaypointPosition.BASE,
                        -20,
                        sleep(1.5),
                        moveL(waypoint("beside")),
                        say("beside"),
                        sleep(0.5)))
                .withWaypoint("beside", ArmRun.place(0, 0.06, 0)),
            ArmRun.table(0.01));
    run.until("beside");
    assertEquals(20, run.pressN(), 5);
    assertEquals(0.06, run.moved().y(), 1e-3);
    assertEquals(-0.01, run.moved().z(), 2e-3);
    run.finish();
  }

  private static ProgramNode screw(
      boolean byForce,
      double value,
      boolean loosen,
      String until,
      double timeoutS,
      ProgramNode... children) {
    return node(
        new Screwdriving(
            new ToolChoice.Active(), byForce, value, loosen, "digital_out[3]", until, timeoutS),
        children);
  }

  @Test
  void theToolFollowsTheScrewUntilItIsDone() {
    ArmRun run =
        new ArmRun(program(screw(true, 10, false, "get_standard_digital_in(1)", 0), say("done")));
    run.advance(2 * FRAMES_PER_S);
    assertTrue(run.output(3));
    assertTrue(run.moved().z() < -0.02, run::toString);
    run.done(new IoCommand.SetInput("digital_in[1]", true));
    run.until("done");
    assertFalse(run.output(3));
    run.finish();
  }

  @Test
  void itFollowsBackwardsWhenAScrewIsLoosened() {
    ArmRun run = new ArmRun(program(screw(true, 10, true, "", 0, sleep(1), say("turned"))));
    run.until("turned");
    assertTrue(run.moved().z() > 0.01, run::toString);
    run.finish();
    assertFalse(run.output(3));
  }

  @Test
  void aSpeedIsNotExceeded() {
    ArmRun run = new ArmRun(program(screw(false, 0.01, false, "", 0, sleep(2))));
    run.advance(2 * FRAMES_PER_S - 100);
    assertEquals(-0.017, run.moved().z(), 0.004);
    run.finish();
  }

  @Test
  void theChildrenEndWithTheScrew() {
    ArmRun run =
        new ArmRun(
            program(
                screw(
                    true,
                    10,
                    false,
                    "get_standard_digital_in(1)",
                    0,
                    sleep(0.5),
                    say("running"),
                    sleep(100),
                    say("never"))),
            ControllerOptions.headless());
    run.until("running");
    run.done(new IoCommand.SetInput("digital_in[1]", true));
    run.finish();
    assertEquals(List.of("running"), run.said());
  }

  @Test
  void tooLongATimeEndsTheProgram() {
    ArmRun run =
        new ArmRun(program(screw(true, 10, false, "get_standard_digital_in(1)", 1), say("done")));
    double before = run.state().timeS();
    run.finish();
    assertEquals(List.of(), run.said());
    assertEquals(1.1, run.state().timeS() - before, 0.15);
    assertFalse(run.output(3));
  }

  private static ConveyorSetup belt(String feature, boolean circular, double ticks) {
    return new ConveyorSetup(1, 0, feature, circular, ticks, false, 0, List.of());
  }

  private static ArmRun onBelt(ConveyorSetup belt, Feature feature) {
    return new ArmRun(
        program(
                sleep(0.5),
                node(
                    new ConveyorTracking(1),
                    sleep(1),
                    say("along"),
                    moveL(waypoint("up")),
                    say("up")),
                say("off"),
                sleep(0.5))
            .withWaypoint("up", ArmRun.place(0, 0, 0.05)),
        ArmRun.installation(List.of(feature), List.of(belt)),
        ControllerOptions.headless().withEncoders(Map.of(0, 5000.0)));
  }

  @Test
  void theArmGoesAlongWithABelt() {
    Feature line =
        new Feature(
            "belt",
            FeatureKind.LINE,
            List.of(new Pose(0.1, 0.1, 0, 0, 0, 0), new Pose(-0.3, 0.1, 0, 0, 0, 0)),
            false,
            true);
    ArmRun run = onBelt(belt("belt", false, 50_000), line);
    run.until("along");
    assertEquals(-0.1, run.moved().x(), 2e-3);
    assertEquals(0, run.moved().y(), 1e-4);
    double before = run.state().timeS();
    run.until("up");
    assertEquals(0.05, run.moved().z(), 1e-4);
    assertEquals(-0.1 - 0.1 * (run.state().timeS() - before), run.moved().x(), 2e-3);
    run.until("off");
    Pose rest = run.moved();
    run.finish();
    assertEquals(rest.x(), run.moved().x(), 1e-5);
    assertEquals(SafetyMode.NORMAL, run.state().safety().safetyMode());
  }

  @Test
  void theArmGoesRoundWithATable() {
    Feature centre =
        new Feature(
            "centre",
            FeatureKind.POINT,
            List.of(new Pose(ArmRun.HERE.x(), ArmRun.HERE.y() - 0.2, 0, 0, 0, 0)),
            false,
            true);
    ArmRun run = onBelt(belt("centre", true, 5000 * 2 * Math.PI * 2), centre);
    run.until("along");
    assertEquals(-0.2 * Math.sin(0.5), run.moved().x(), 2e-3);
    assertEquals(0.2 * Math.cos(0.5) - 0.2, run.moved().y(), 2e-3);
    run.finish();
  }
}
