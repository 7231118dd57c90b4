package org.pendant.controller;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;

/** An arm that holds a tool of 150 mm straight down, with a table below it or without one. */
final class PressingArm {
  static final Joints START = new Joints(0, -1.5708, -1.5708, -1.5708, 1.5708, 0);

  /** Every program begins with it. */
  static final String TOOL = "set_tcp(p[0, 0, 0.15, 0, 0, 0])\n";

  /**
   * The manual's example of tool_contact: down until something is met, then back to where it was.
   */
  static final String TOUCH_AND_GO_BACK =
      """
      while True:
        step_back = tool_contact()
        if step_back <= 0:
          speedl([0, 0, -0.100, 0, 0, 0], 0.5, t=get_steptime())
        else:
          q = get_actual_joint_positions_history(step_back)
          stopl(3)
          movel(q)
          break
        end
      end
      """;

  final RunningProgram running;

  PressingArm(ControllerOptions options) {
    running = new RunningProgram(options.withStart(START));
  }

  /** With nothing around it. */
  PressingArm() {
    this(ControllerOptions.headless());
  }

  /** With a table, this far below the tool. */
  static PressingArm overTable(String robot, double gapM, Material material) {
    return new PressingArm(tableBelow(robot, gapM, material));
  }

  static PressingArm overTable(double gapM) {
    return overTable(ControllerOptions.DEFAULT_ROBOT, gapM, Material.DEFAULT);
  }

  static ControllerOptions tableBelow(String robot, double gapM, Material material) {
    SceneObject table =
        new SceneObject.Plane(
            "table",
            new Vector3(0, 0, tcpAtStart(robot).z() - gapM),
            new Vector3(0, 0, 1),
            material);
    return ControllerOptions.headless()
        .withRobot(robot)
        .withScene(new Scene(List.of(table), Optional.empty(), List.of()));
  }

  static Pose tcpAtStart(String robot) {
    return new ForwardKinematics(ArmLibrary.load(robot))
        .tcpPose(START, new Pose(0, 0, 0.15, 0, 0, 0));
  }

  void start(String program) {
    running.start(TOOL + program);
  }

  void frames(int count) {
    running.advance(count);
  }

  /** Advances and calls {@code each} after every frame. */
  void frames(int count, Runnable each) {
    for (int i = 0; i < count; i++) {
      running.advance(1);
      each.run();
    }
  }

  ArmState arm() {
    return running.state().arm();
  }

  /** Where the TCP is to be. */
  Pose target() {
    return arm().targetTcpInBase();
  }

  /** With what the tool presses down, N. */
  double pressN() {
    return running.state().readings().flangeWrenchInBase().fz();
  }

  /** Waits until the tool presses. */
  void untilContact() {
    for (int i = 0; i < 2000 && pressN() < 1; i++) {
      running.advance(1);
    }
  }
}
