package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.body;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.suppressed;

import org.junit.jupiter.api.Test;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramNode;

/** The script of decisions and loops. */
final class FlowTextTest {
  private static ProgramNode loop(LoopRule rule, ProgramNode... children) {
    return node(new FlowStep.Loop(rule), children);
  }

  @Test
  void alternativesStandInsideOfEachOther() {
    assertEquals(
        """
        $ 2 "If x \u225f 1"
        if (x == 1):
          $ 3 "Wait: 1"
          sleep(1.0)
        else:
          $ 4 "ElseIf x > 2"
          if (x > 2):
            $ 5 "Wait: 2"
            sleep(2.0)
          else:
            $ 8 "Else" "noBreak"
            $ 9 "Wait: 3"
            sleep(3.0)
          end
        end
        """,
        body(
            node(new FlowStep.If("x == 1", false), sleep(1)),
            node(new FlowStep.ElseIf("x > 2"), sleep(2)),
            suppressed(node(new FlowStep.ElseIf("x > 3"), sleep(2))),
            node(new FlowStep.Else(), sleep(3))));
  }

  @Test
  void manyAlternativesStandBesideEachOther() {
    ProgramNode[] chain = new ProgramNode[202];
    chain[0] = node(new FlowStep.If("x == 0", false), sleep(1));
    for (int i = 1; i <= 200; i++) {
      chain[i] = node(new FlowStep.ElseIf("x == " + i), sleep(1));
    }
    chain[201] = node(new FlowStep.Else(), sleep(1));
    String text = body(chain);
    assertEquals(200, text.split("elif ", -1).length - 1);
    assertEquals(1, text.split("\nend", -1).length - 1);
  }

  @Test
  void continuousIfRunsInAThreadThatIsKilled() {
    assertEquals(
        """
        $ 2 "If x > 1"
        global thread_flag_2 = 0
        thread Thread_if_2():
          $ 3 "Wait: 1"
          sleep(1.0)
          thread_flag_2 = 1
        end
        if (x > 1):
          global thread_handler_2 = run Thread_if_2()
          while (thread_flag_2 == 0):
            if not(x > 1):
              kill thread_handler_2
              thread_flag_2 = 2
            else:
              sync()
            end
          end
        else:
          thread_flag_2 = 2
        end
        if (thread_flag_2 == 2):
          $ 4 "ElseIf x > 0"
          if (x > 0):
            $ 5 "Wait: 2"
            sleep(2.0)
          else:
            $ 6 "Else" "noBreak"
            $ 7 "Wait: 3"
            sleep(3.0)
          end
        end
        """,
        body(
            node(new FlowStep.If("x > 1", true), sleep(1)),
            node(new FlowStep.ElseIf("x > 0"), sleep(2)),
            node(new FlowStep.Else(), sleep(3))));
  }

  @Test
  void anAlternativeMayBeLookedAtContinuouslyItself() {
    assertEquals(
        """
        $ 2 "If x > 1"
        if (x > 1):
          $ 3 "Wait: 1"
          sleep(1.0)
        else:
          $ 4 "ElseIf x > 0"
          global thread_flag_4 = 0
          thread Thread_if_4():
            $ 5 "Wait: 2"
            sleep(2.0)
            thread_flag_4 = 1
          end
          if (x > 0):
            global thread_handler_4 = run Thread_if_4()
            while (thread_flag_4 == 0):
              if not(x > 0):
                kill thread_handler_4
                thread_flag_4 = 2
              else:
                sync()
              end
            end
          else:
            thread_flag_4 = 2
          end
          if (thread_flag_4 == 2):
            $ 6 "Else" "noBreak"
            $ 7 "Wait: 3"
            sleep(3.0)
          end
        end
        """,
        body(
            node(new FlowStep.If("x > 1", false), sleep(1)),
            node(new FlowStep.ElseIf("x > 0", true), sleep(2)),
            node(new FlowStep.Else(), sleep(3))));
  }

  @Test
  void loops() {
    assertEquals(
        """
        $ 2 "Loop"
        while (True):
          $ 3 "Wait: 1"
          sleep(1.0)
        end
        """,
        body(loop(new LoopRule.Forever(), sleep(1))));
    assertEquals(
        """
        $ 2 "Loop n + 1 times"
        i = 0
        while (i < (n + 1)):
          $ 3 "Loop 3 times"
          Loop_1 = 0
          while (Loop_1 < 3):
            $ 4 "Wait: 1"
            sleep(1.0)
            Loop_1 = Loop_1 + 1
          end
          i = i + 1
        end
        """,
        body(loop(new LoopRule.Times("n + 1", "i"), loop(new LoopRule.Times("3", ""), sleep(1)))));
    assertEquals(
        """
        $ 2 "Loop x < 1"
        while (x < 1):
          $ 3 "Wait: 1"
          sleep(1.0)
        end
        """,
        body(loop(new LoopRule.While("x < 1", false), sleep(1))));
  }

  @Test
  void loopsAreGivenNoWait() {
    assertEquals(
        """
        $ 2 "Loop"
        while (True):
          $ 3 "x \u2254 x + 1"
          global x = x + 1
        end
        """,
        body(loop(new LoopRule.Forever(), TestTrees.assign("x", "x + 1"))));
    assertEquals(
        """
        $ 2 "Loop True"
        while (True):
        end
        """,
        body(loop(new LoopRule.While("True", false))));
    assertEquals(
        """
        $ 2 "Loop x < 1"
        while (x < 1):
        end
        """,
        body(loop(new LoopRule.While("x < 1", false))));
  }

  @Test
  void continuousLoopRunsInAThreadThatIsKilled() {
    assertEquals(
        """
        $ 2 "Loop x < 1"
        thread Thread_while_2():
          while (True):
            $ 3 "Wait: 1"
            sleep(1.0)
          end
        end
        if (x < 1):
          global thread_handler_2 = run Thread_while_2()
          while (x < 1):
            sync()
          end
          kill thread_handler_2
        end
        """,
        body(loop(new LoopRule.While("x < 1", true), sleep(1))));
  }

  @Test
  void switchComputesItsValueOnce() {
    assertEquals(
        """
        $ 2 "Switch f()"
        switch_1 = f()
        if (1 == switch_1):
          $ 3 "Case 1" "noBreak"
          $ 4 "Wait: 1"
          sleep(1.0)
        elif ((-2) == switch_1):
          $ 5 "Case -2" "noBreak"
        else:
          $ 6 "Default case" "noBreak"
          $ 7 "Wait: 3"
          sleep(3.0)
        end
        """,
        body(
            node(
                new FlowStep.Switch("f()"),
                node(new FlowStep.Case("1"), sleep(1)),
                node(new FlowStep.Case("-2")),
                node(new FlowStep.DefaultCase(), sleep(3)))));
  }

  @Test
  void strayBranchesLeaveARemark() {
    assertEquals(
        """
        $ 2 "Else" "noBreak"
        # an If must stand before this
        $ 3 "Case 1" "noBreak"
        # a Switch must stand above this
        """,
        body(node(new FlowStep.Else()), node(new FlowStep.Case("1"))));
  }
}
