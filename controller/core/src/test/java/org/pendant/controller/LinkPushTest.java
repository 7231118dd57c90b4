package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.LinkContact;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;
import org.pendant.script.vm.ProgramState;

/** Links of the arm push objects that have a mass, and feel them. */
class LinkPushTest {
  private static final double TABLE_M = 0.54;

  private static final String TURN =
      """
      set_tcp(p[0, 0, 0.1, 0, 0, 0])
      movej([1.5708, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=1, v=0.5)
      textmsg("there")
      """;

  /** A box on a small table just below the forearm, which turns towards it. */
  private static Scene scene(double massKg) {
    return new Scene(
        List.of(
            new SceneObject.Plane(
                "floor", new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT),
            new SceneObject.Box(
                "table",
                new Pose(0.14, 0.14, TABLE_M / 2, 0, 0, 0),
                new Vector3(0.12, 0.12, TABLE_M),
                Material.DEFAULT),
            new SceneObject.Box(
                "part",
                new Pose(0.14, 0.14, TABLE_M + 0.04, 0, 0, 0),
                new Vector3(0.08, 0.08, 0.08),
                Material.DEFAULT,
                massKg)),
        Optional.empty(),
        List.of());
  }

  private static double heightM(ControllerState state) {
    return state.moved().getFirst().poseInBase().z();
  }

  private static RunningProgram turning(Scene scene) {
    RunningProgram running = new RunningProgram(ControllerOptions.headless().withScene(scene));
    running.start(TURN);
    return running;
  }

  @Test
  void theForearmSweepsALightBoxOffTheTable() {
    RunningProgram running = turning(scene(1));
    running.finish();
    assertEquals(List.of("there"), running.said(), () -> running.reported().toString());
    assertTrue(heightM(running.state()) < 0.5, () -> running.state().moved().toString());
  }

  @Test
  void theBaseFeelsTheFrictionOfABoxThatTheForearmPushes() {
    RunningProgram running = turning(scene(8));
    double most = 0;
    while (running.programState() == ProgramState.RUNNING
        && heightM(running.state()) > TABLE_M + 0.03) {
      running.advance(1);
      most = Math.max(most, Math.abs(running.state().readings().externalTorqueNm().get(0)));
    }
    // 0.3 of 79 N, 0.2 m from the axis, and the box itself is set in motion
    assertTrue(most > 3 && most < 50, "felt " + most + " Nm");
  }

  @Test
  void aBoxThatIsTooHeavyToBePushedStopsTheArm() {
    RunningProgram running = turning(scene(500));
    running.finish();
    assertEquals(
        "C157A0", running.state().safety().stop().orElseThrow().codeText(), running::toString);
  }

  @Test
  void linksThatPassThroughPushNothing() {
    RunningProgram running = turning(scene(1).withLinks(LinkContact.PASS));
    running.finish();
    assertEquals(TABLE_M + 0.04, heightM(running.state()), 1e-3);
  }
}
