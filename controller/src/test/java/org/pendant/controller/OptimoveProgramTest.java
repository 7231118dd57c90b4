package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.machine.ProgramState;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.language.source.Source;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/** Moves with all that the arm can do, by an arm that has mass and drives. */
final class OptimoveProgramTest {
  private final RunningProgram running = new RunningProgram();

  @Test
  void anArmWithALoadFollowsFullSharesWithoutAnyStop() {
    running.run(
        """
        set_target_payload(3, [0, 0, 0.1], [0, 0, 0, 0, 0, 0])
        optimovej([1.5, -1.2, -1.2, -1.5708, 1.5708, 0], a=1, v=1)
        optimovej([-2.5, -1.5, -1.8, -1.0, 1.5708, 3], a=1, v=1)
        optimovej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=1, v=1, r=0.05)
        optimovel(struct(pose=p[0.1, 0.2, 0.1, 0, 0, 0], frame="tcp"), a=1, v=1)
        optimovej([1.2, -0.3, -0.5, -1, 1, 1], a=1, v=1)
        textmsg("there")
        """);
    assertEquals(List.of("there"), running.said());
    assertEquals(List.of(), running.reported());
  }

  @Test
  void leadsToAnObjectOfTheSceneAndToAPoseInItsFrame() {
    Pose shelf = new Pose(-0.3, -0.4, 0.3, 0, Math.PI, 0);
    SceneObject box =
        new SceneObject.Box("shelf", shelf, new Vector3(0.01, 0.01, 0.01), new Material(10, 0, 0));
    Scene scene = new Scene(List.of(box), Optional.empty(), List.of());
    Controller controller = new Controller(ControllerOptions.headless().withScene(scene));
    run(controller, "optimovej(struct(pose=p[0, 0, -0.1, 0, 0, 0], frame=\"shelf\"))\n");
    Pose above = controller.state().arm().targetTcpInBase();
    assertEquals(0, Poses.distance(new Pose(-0.3, -0.4, 0.4, 0, Math.PI, 0), above), 1e-9);
    run(controller, "tool_wrench_limit_disable()\noptimovel(\"shelf\", v=0.1)\n");
    assertEquals(0, Poses.distance(shelf, controller.state().arm().targetTcpInBase()), 1e-9);
  }

  private static void run(Controller controller, String text) {
    Source source = Source.of("goal.script", text.getBytes(StandardCharsets.ISO_8859_1));
    var _ =
        controller.submit(
            new Command.StartProgram(controller.load(source).program().orElseThrow()));
    controller.advance();
    for (int i = 0; controller.state().program().state() == ProgramState.RUNNING; i++) {
      assertTrue(i < 10_000, "still running");
      controller.advance();
    }
    assertEquals(ProgramState.STOPPED, controller.state().program().state());
  }

  @Test
  void aBlendOfProcessMovesIsPausedAndGoesOnOnItsPath() {
    running.start(
        """
        home = get_target_tcp_pose()
        movep(pose_add(p[-0.1, 0, 0, 0, 0, 0], home), r=0.03)
        movep(pose_add(p[-0.1, 0.1, 0, 0, 0, 0], home), r=0.03)
        movec(pose_add(p[-0.05, 0.15, 0, 0, 0, 0], home), pose_add(p[0, 0.1, 0, 0, 0, 0], home))
        textmsg("there")
        """);
    running.advance(300);
    running.done(new Command.PauseProgram());
    running.advance(300);
    assertEquals(Joints.ZERO, running.state().arm().targetSpeedRadPerS());
    running.done(new Command.ResumeProgram());
    running.finish();
    assertEquals(List.of("there"), running.said());
    assertTrue(running.reported().isEmpty(), () -> running.reported().toString());
  }
}
