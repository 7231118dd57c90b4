package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.world.LinkContact;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;
import org.pendant.script.vm.ProgramState;

/** Links of the arm that get into things stop it. */
class LinkStopTest {
  private static final String TURN =
      """
      set_tcp(p[0, 0, 0.1, 0, 0, 0])
      movej([1.5708, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=1, v=1)
      textmsg("there")
      """;

  /** A post beside the forearm, which lies level along x. */
  private static final Scene SCENE =
      new Scene(
          List.of(
              new SceneObject.Box(
                  "post",
                  new Pose(0.22, 0.2, 0.6, 0, 0, 0),
                  new Vector3(0.05, 0.05, 1),
                  Material.DEFAULT)),
          Optional.empty(),
          List.of());

  private static RunningProgram turning(ControllerOptions options) {
    RunningProgram running = new RunningProgram(options);
    running.start(TURN);
    for (int i = 0; i < 3000 && running.programState() == ProgramState.RUNNING; i++) {
      running.advance(1);
    }
    return running;
  }

  private static SafetyStop stop(RunningProgram running) {
    return running.state().safety().stop().orElseThrow();
  }

  @Test
  void aForearmThatMeetsAnObjectIsAProtectiveStopThatSaysWhatMetWhat() {
    RunningProgram running = turning(ControllerOptions.headless().withScene(SCENE));
    assertEquals(ProgramState.PAUSED, running.programState());
    SafetyStop stop = stop(running);
    assertEquals(SafetyMode.PROTECTIVE_STOP, stop.mode());
    assertEquals("C157A2", stop.codeText());
    assertEquals("the forearm has hit \"post\"", stop.sentence());
    assertEquals(List.of("forearm"), stop.hitLinks());
    assertTrue(stop.value() > 0 && stop.value() < 0.004, stop::message);
    assertTrue(stop.message().endsWith(" m, limit 0 m"), stop::message);
  }

  @Test
  void theArmCanBeTakenBackAfterTheStop() {
    RunningProgram running = turning(ControllerOptions.headless().withScene(SCENE));
    running.advance(2600);
    running.done(new SafetyCommand.UnlockProtectiveStop(true));
    running.done(new ProgramCommand.StopProgram());
    running.start(
        "movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=1, v=1)\ntextmsg(\"back\")\n");
    running.finish();
    assertEquals(List.of("back"), running.said());
  }

  @Test
  void linksPassThroughWhereTheSceneSaysSo() {
    RunningProgram running =
        turning(ControllerOptions.headless().withScene(SCENE.withLinks(LinkContact.PASS)));
    assertEquals(List.of("there"), running.said());
  }

  @Test
  void anIdealArmTouchesNothing() {
    RunningProgram running =
        turning(ControllerOptions.headless().withArm(ArmChoice.IDEAL).withScene(SCENE));
    assertEquals(List.of("there"), running.said());
  }

  @Test
  void theNearestDistanceIsAQuantityAndIsTheDepthAtTheStop() {
    StateQuantity distance = StateQuantities.of("link_distance");
    RunningProgram running = new RunningProgram(ControllerOptions.headless().withScene(SCENE));
    running.start(TURN);
    running.advance(100);
    double apart = distance.number(running.state());
    assertTrue(apart > 0.05 && apart < 0.2, () -> apart + " m");
    running.finish();
    assertEquals(-stop(running).value(), distance.number(running.state()), 1e-12);
  }
}
