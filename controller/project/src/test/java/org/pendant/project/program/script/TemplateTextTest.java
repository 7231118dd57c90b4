package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.abc;
import static org.pendant.project.program.script.TestTrees.body;
import static org.pendant.project.program.script.TestTrees.moveL;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.suppressed;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.MotionStep.Direction;
import org.pendant.project.program.MotionStep.Until;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.Pattern;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TemplateStep.ForceKind;
import org.pendant.project.program.TemplateStep.Palletizing;
import org.pendant.project.program.TemplateStep.Part;
import org.pendant.project.program.TemplateStep.PartKind;
import org.pendant.project.program.TemplateStep.PatternPoint;
import org.pendant.project.program.TemplateStep.PatternRole;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;

/** What directions and templates look like in the script. */
final class TemplateTextTest {
  private static final OptionalDouble NONE = OptionalDouble.empty();

  private static ProgramNode down(UntilRule rule, ProgramNode... children) {
    return node(new Direction("Base", 0, 0, -1, NONE, NONE), node(new Until(rule), children));
  }

  private static ProgramNode point(PatternRole role, String waypoint, MoveKind kind) {
    return node(new PatternPoint(role, waypoint, kind, 0.5, 1.2, NONE));
  }

  @Test
  void aDirectionMovesInAThreadThatIsWatched() {
    assertEquals(
        """
        $ 2 "MoveL"
        $ 3 "Direction: Base Z-"
        global move_thread_flag_3 = 0
        thread move_thread_3():
          enter_critical
          move_thread_flag_3 = 1
          local towardsPos = calculate_point_to_move_towards(p[0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, -1.0], 1000.0)
          movel(towardsPos, a=1.2, v=0.5)
          move_thread_flag_3 = 2
          exit_critical
        end
        move_thread_flag_3 = 0
        move_thread_han_3 = run move_thread_3()
        while (True):
          local targetTcpDirection = get_target_tcp_speed()
          local stepsToRetract = tool_contact(direction=targetTcpDirection)
          if (stepsToRetract > 0):
            kill move_thread_han_3
            stopl(3.0)
            local backTrackMovement = get_actual_joint_positions_history(stepsToRetract)
            local contactPose = get_forward_kin(backTrackMovement)
            local posDir = [targetTcpDirection[0], targetTcpDirection[1], targetTcpDirection[2]]
            local retractTo = contactPose
            if (norm(posDir) > 1e-6):
              local normalizedPosDir = normalize(posDir)
              local additionalRetraction = p[normalizedPosDir[0] * 0.0, normalizedPosDir[1] * 0.0, normalizedPosDir[2] * 0.0, 0, 0, 0]
              retractTo = pose_sub(contactPose, additionalRetraction)
            end
            movel(retractTo, a=3.0, v=0.1)
            $ 4 "Until tool contact"
            $ 5 "textmsg('touched')"
            textmsg("touched")
            break
          end
          sync()
        end
        """,
        body(moveL(down(new UntilRule.Contact(0, 3), say("touched")))));
  }

  @Test
  void palletizingComputesThePlaceFromTheCount() {
    assertEquals(
        """
        $ 2 "Palletizing: P"
        if (P_count == 0):
          $ 3 "Before start" "noBreak"
          $ 4 "textmsg('before')"
          textmsg("before")
        end
        global pallet_place_1 = interpolate_pose(A_p, B_p, P_count / 3.0)
        $ 5 "Approach" "breakAfter"
        movej(get_inverse_kin(pose_trans(pallet_place_1, pose_trans(pose_inv(A_p), B_p)), qnear=B_q), a=1.2, v=0.5)
        $ 6 "Point" "breakAfter"
        movel(pallet_place_1, a=1.2, v=0.5)
        global P_count = P_count + 1
        if (P_count >= 4):
          global P_count = 0
        end
        """,
        body(
            node(
                new Palletizing("P", new Pattern.Line("A", "B", 4), "Base", false),
                node(new Part(PartKind.BEFORE_START), say("before")),
                point(PatternRole.APPROACH, "B", MoveKind.JOINT),
                point(PatternRole.POINT, "A", MoveKind.LINEAR),
                suppressed(point(PatternRole.EXIT, "C", MoveKind.LINEAR)))));
  }

  @Test
  void forceModeIsAroundTheChildren() {
    assertEquals(
        """
        $ 2 "Force: simple"
        sleep(0.02)
        zero_ftsensor()
        force_mode(tool_pose(), [0, 0, 1, 0, 0, 0], [0.0, 0.0, 20.0, 0.0, 0.0, 0.0], 2, [0.1, 0.1, 0.15, 0.3, 0.3, 0.3])
        $ 3 "textmsg('pressed')"
        textmsg("pressed")
        end_force_mode()
        stopl(5.0)
        """,
        body(
            node(
                new TemplateStep.Force(
                    ForceKind.SIMPLE,
                    "Tool",
                    List.of(false, false, true, false, false, false),
                    List.of(0.0, 0.0, 20.0, 0.0, 0.0, 0.0),
                    List.of(0.1, 0.1, 0.15, 0.3, 0.3, 0.3)),
                say("pressed"))));
  }

  @Test
  void aScrewMayEndWithItsChildren() {
    assertEquals(
        """
        $ 2 "Screwdriving: loosen"
        zero_ftsensor()
        sleep(0.02)
        screw_driving(-20.0, 0.1)
        $ 3 "textmsg('turned')"
        textmsg("turned")
        end_screw_driving()
        stopl(5.0)
        """,
        body(
            node(
                new TemplateStep.Screwdriving(new ToolChoice.Active(), true, 20, true, "", "", 0),
                say("turned"))));
  }

  @Test
  void whatIsUnfinishedOnlySaysSo() {
    String text =
        body(
            moveL(node(new Direction("Base", 0, 0, -1, NONE, NONE))),
            moveL(
                node(
                    new Direction("Base", 0, 0, 0, NONE, NONE),
                    node(new Until(new UntilRule.Distance(1))))),
            node(
                new Palletizing("P", new Pattern.Line("A", "missing", 4), "Base", false),
                point(PatternRole.POINT, "A", MoveKind.LINEAR)),
            point(PatternRole.POINT, "A", MoveKind.LINEAR),
            node(new TemplateStep.ConveyorTracking(1)),
            node(
                new TemplateStep.Seek(
                    true, "S", "A", "Base", List.of(), 0.1, 0.1, "True", 0.1, 0.1)));
    assertTrue(
        text.lines()
            .map(String::strip)
            .allMatch(line -> line.startsWith("$") || line.startsWith("# ")),
        text);
  }

  @Test
  void aDistanceMayBlendAndOtherEndsStandBesideIt() {
    String text =
        body(
            moveL(
                node(
                    new Direction("Tool", 1, 0, 0, NONE, NONE),
                    node(new Until(new UntilRule.Expression("x > 1"))),
                    node(new Until(new UntilRule.Distance(0.2, OptionalDouble.of(0.05)))))));
    assertTrue(
        text.contains("calculate_point_to_move_towards(get_forward_kin(), [1.0, 0.0, 0.0], 0.2)"),
        text);
    assertTrue(text.contains("movel(towardsPos, a=1.2, v=0.5, r=0.05)"), text);
    assertTrue(
        text.contains(
            """
            while (True):
              if (x > 1):
                kill move_thread_han_3
                stopl(1.2)
                $ 4 "Until x > 1"
                break
              end
              sleep(1.0E-10)
              if (move_thread_flag_3 > 1):
                join move_thread_han_3
                $ 5 "Until distance: 0.2 m"
                break
              end
              sync()
            end
            """),
        text);
  }

  @Test
  void aBreakpointOnAnUntilStopsWhereItHasEndedTheMove() {
    ProgramTree tree = abc(program(moveL(down(new UntilRule.Distance(0.1)))));
    GeneratedScript script = ScriptGenerator.generate("test", tree, Installation.NONE);
    List<String> lines = script.text().lines().toList();
    assertEquals("      break", lines.get(first(script, tree, 4) - 1));
    assertEquals("  global move_thread_flag_3 = 0", lines.get(first(script, tree, 3) - 1));
  }

  private static int first(GeneratedScript script, ProgramTree tree, int number) {
    return script.of(tree.nodes().get(number - 1).key()).orElseThrow().first();
  }
}
