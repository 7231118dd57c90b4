package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.world.Material;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;

/** Programs that move until the tool meets something (manual 16.66, 16.67). */
final class ToolContactProgramTest {
  private static final double GAP_M = 0.05;

  /** Moves down in a thread until {@code CONTACT}, then back to where the contact began. */
  private static final String APPROACH =
      """
      goal = pose_trans(p[0, 0, -0.1, 0, 0, 0], get_target_tcp_pose())
      thread down():
        movel(goal, a=0.5, v=SPEED)
      end
      d = run down()
      steps = 0
      while steps <= 0:
        steps = CONTACT
        sync()
      end
      q = get_actual_joint_positions_history(steps)
      kill d
      stopl(3)
      movel(q)
      onset = get_forward_kin(q)
      textmsg(onset[2])
      textmsg(steps)
      """;

  private static String approach(double speed, String contact) {
    return APPROACH.replace("SPEED", String.valueOf(speed)).replace("CONTACT", contact);
  }

  @ParameterizedTest
  @CsvSource({
    "0.1, 40000, tool_contact()",
    "0.1, 10000, tool_contact()",
    "0.02, 40000, tool_contact()",
    "0.005, 10000, tool_contact()",
    "0.1, 40000, 'tool_contact(direction=get_target_tcp_speed())'",
    "0.1, 40000, 'tool_contact([0, 0, -1, 0, 0, 0])'",
    "0.1, 40000, 'tool_contact(force_threshold=20)'",
    "0.1, 10000, 'tool_contact([0, 0, -3, 1, 2, 3], 30)'"
  })
  void theHistoryLeadsBackToWhereTheContactBegan(double speed, double stiffness, String contact) {
    PressingArm arm = PressingArm.overTable("ur5e", GAP_M, new Material(stiffness, 0.2, 0.3));
    double table = PressingArm.tcpAtStart("ur5e").z() - GAP_M;
    arm.start(approach(speed, contact));
    arm.running.finish();
    assertEquals(2, arm.running.said().size(), () -> arm.running.reported().toString());
    // a frame of travel, and what half a newton presses in
    double tolerance = 1.01 * (speed * 0.002 + 0.5 / stiffness);
    assertEquals(table, arm.running.numbers().get(0), tolerance);
    assertTrue(arm.running.numbers().get(1) >= 1);
    assertEquals(SafetyMode.NORMAL, arm.running.state().safety().safetyMode());
  }

  @Test
  void theExampleOfTheManualGoesBackToTheSurface() {
    PressingArm arm = PressingArm.overTable(GAP_M);
    double table = PressingArm.tcpAtStart("ur5e").z() - GAP_M;
    arm.start(PressingArm.TOUCH_AND_GO_BACK);
    arm.running.finish();
    assertEquals(SafetyMode.NORMAL, arm.running.state().safety().safetyMode());
    assertEquals(table, arm.target().z(), 2.2e-4);
  }

  @Test
  void withoutAnythingToTouchThereIsNoContact() {
    PressingArm arm = new PressingArm();
    arm.start(
        """
        goal = pose_trans(p[0, 0, -0.1, 0, 0, 0], get_target_tcp_pose())
        global most = 0
        thread watch():
          while True:
            c = tool_contact()
            if c > most:
              most = c
            end
            sync()
          end
        end
        w = run watch()
        movel(goal, a=3, v=1)
        sleep(0.5)
        textmsg(most)
        """);
    arm.running.finish();
    assertEquals(List.of("0"), arm.running.said());
  }

  @Test
  void aContactFromBehindDoesNotCount() {
    PressingArm arm = PressingArm.overTable(GAP_M);
    arm.start(
        approach(0.1, "tool_contact()")
            .replace(
                "steps = tool_contact()",
                "behind = tool_contact([0, 0, 1, 0, 0, 0])\n"
                    + "  textmsg(behind)\n  steps = tool_contact()"));
    arm.running.finish();
    List<String> said = arm.running.said();
    assertTrue(said.subList(0, said.size() - 2).stream().allMatch("0"::equals), said::toString);
  }

  @Test
  void aWrongPayloadThatHangsStillIsNoContact() {
    PressingArm arm = new PressingArm();
    arm.running.done(new WorldCommand.AttachLoad(Optional.of(Payload.of(2, 0, 0, 0.05))));
    arm.frames(10_000);
    arm.start("sleep(0.1)\ntextmsg(tool_contact())\n");
    arm.running.finish();
    assertEquals(List.of("0"), arm.running.said());
  }

  @Test
  void zeroingTheSensorIsNoContact() {
    PressingArm arm = new PressingArm();
    arm.start(
        """
        sleep(1)
        textmsg(tool_contact() > 0)
        zero_ftsensor()
        sleep(0.1)
        textmsg(tool_contact())
        """);
    arm.frames(100);
    arm.running.done(new WorldCommand.PushTool(new Wrench(0, 0, 20, 0, 0, 0)));
    arm.running.finish();
    assertEquals(List.of("True", "0"), arm.running.said());
  }
}
