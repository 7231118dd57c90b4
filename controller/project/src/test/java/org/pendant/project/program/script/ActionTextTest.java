package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.assign;
import static org.pendant.project.program.script.TestTrees.body;
import static org.pendant.project.program.script.TestTrees.once;
import static org.pendant.project.program.script.TestTrees.output;
import static org.pendant.project.program.script.TestTrees.script;
import static org.pendant.project.program.script.TestTrees.set;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.suppressed;
import static org.pendant.project.program.script.TestTrees.tree;
import static org.pendant.project.program.script.TestTrees.waitFor;

import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ActionStep.InputKind;
import org.pendant.project.program.ActionStep.PopupKind;
import org.pendant.project.program.ActionStep.TimerAction;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Section;
import org.pendant.project.program.Setting;
import org.pendant.project.program.WaitFor;

/** The script of nodes that neither move nor decide. */
final class ActionTextTest {
  /** Without labels. */
  private static String code(ProgramNode... nodes) {
    return body(nodes)
        .lines()
        .filter(line -> !line.startsWith("$"))
        .collect(Collectors.joining("\n"));
  }

  @Test
  void waits() {
    assertEquals("sleep(0.5)", code(sleep(0.5)));
    assertEquals("", code(waitFor(new WaitFor.Nothing())));
    assertEquals(
        """
        while (get_standard_digital_in(3) == False):
          sync()
        end\
        """,
        code(waitFor(new WaitFor.Digital("digital_in[3]", true))));
    assertEquals(
        """
        while (get_standard_analog_in(1) <= 2.5):
          sync()
        end\
        """,
        code(waitFor(new WaitFor.Analog("analog_in[1]", true, 2.5))));
    assertEquals(
        """
        while (not(x > 1)):
          sync()
        end\
        """,
        code(waitFor(new WaitFor.Expression(" x > 1 "))));
  }

  @Test
  void setsDigitalOutputsOfEveryBank() {
    assertEquals("set_standard_digital_out(1, True)", code(output(1, true)));
    assertEquals(
        "set_configurable_digital_out(2, False)",
        code(set(new Setting.Digital("configurable_out[2]", false))));
    assertEquals(
        "set_tool_digital_out(0, True)", code(set(new Setting.Digital("tool_out[0]", true))));
    assertEquals("set_flag(31, True)", code(set(new Setting.Digital("flag[31]", true))));
    assertEquals(
        "write_output_boolean_register(5, True)",
        code(set(new Setting.Digital("output_boolean_register[5]", true))));
    assertEquals(
        "# there is no such signal: digital_out[8]",
        code(set(new Setting.Digital("digital_out[8]", true))));
    assertEquals(
        "# there is no such signal: digital_in[0]",
        code(set(new Setting.Digital("digital_in[0]", true))));
  }

  @Test
  void setsAnalogOutputsToAPartOfTheirRange() {
    assertEquals(
        "set_standard_analog_out(0, ((0.012) - 0.004) / 0.016)",
        code(set(new Setting.Analog("analog_out[0]", 0.012))));
  }

  @Test
  void setsOtherThings() {
    assertEquals("", code(set(new Setting.Nothing())));
    assertEquals(
        """
        set_standard_digital_out(0, True)
        sleep(0.2)
        set_standard_digital_out(0, False)\
        """,
        code(set(new Setting.Pulse("digital_out[0]", 0.2))));
    assertEquals(
        "set_standard_digital_out(0, x == 3)",
        code(set(new Setting.Expression("digital_out[0]", "x == 3"))));
    assertEquals(
        "set_target_payload(1.5, [0.0, 0.0, 0.03])",
        code(set(new Setting.Payload(1.5, 0, 0, 0.03))));
    assertEquals(
        "set_tcp(p[0.0, 0.0, 0.1, 0.0, 0.0, 0.0])",
        code(set(new Setting.Tcp("", Pose.of(0, 0, 0.1, 0, 0, 0)))));
    assertEquals("global parts = parts + 1", code(set(new Setting.Increment("parts"))));
  }

  @Test
  void timersRunBesideTheProgramAndKeepTheValueThatTheyHaveAtFirst() {
    String text =
        ScriptGenerator.generate(
                "test",
                tree(
                    node(new Section.InitialValues(List.of(new Section.InitialValue("kept", "5")))),
                    once(timer("kept", TimerAction.START), timer("new", TimerAction.RESET))),
                Installation.NONE)
            .text();
    assertTrue(
        text.contains(
            """
              global kept = 5
              global kept_is_counting = False
              global new = 0.0
              global new_is_counting = False
              thread Timer_Thread():
            """),
        text);
    assertTrue(text.contains("\n  run Timer_Thread()\n"), text);
    assertTrue(text.contains("\n  new = 0.0\n"), text);
  }

  private static ProgramNode timer(String name, TimerAction action) {
    return node(new ActionStep.Timer(name, action));
  }

  @Test
  void showsPopups() {
    assertEquals(
        "popup(\"Load the tray\", \"Message\", False, False, blocking=True)",
        code(node(new ActionStep.Popup("Load the tray", false, PopupKind.MESSAGE, false))));
    assertEquals(
        "popup(str_cat(\"\", parts), \"Warning\", True, False, blocking=True)",
        code(node(new ActionStep.Popup("parts", true, PopupKind.WARNING, false))));
    assertEquals(
        """
        popup("No part", "Error", False, True, blocking=False)
        halt\
        """,
        code(node(new ActionStep.Popup("No part", false, PopupKind.ERROR, true))));
  }

  @Test
  void textsStayOnOneLineAndWithinTheirQuotes() {
    assertEquals(
        "popup(\"say 'yes' or no\\\", \"Message\", False, False, blocking=True)",
        code(node(new ActionStep.Popup("say \"yes\"\nor no\\", false, PopupKind.MESSAGE, false))));
    assertEquals(
        """
        # one
        # two "end\"\
        """,
        code(node(new ActionStep.Comment("one\ntwo \"end\""))));
  }

  @Test
  void assignsAndAsks() {
    assertEquals("global x = y + 1", code(assign("x", "y + 1")));
    assertEquals(
        "global b = request_boolean_from_primary_client(\"Go on?\")",
        code(node(new ActionStep.OperatorInput("b", InputKind.BOOLEAN, "Go on?"))));
    assertEquals(
        "global i = request_integer_from_primary_client(\"n\")",
        code(node(new ActionStep.OperatorInput("i", InputKind.INTEGER, "n"))));
    assertEquals(
        "global f = request_float_from_primary_client(\"n\")",
        code(node(new ActionStep.OperatorInput("f", InputKind.FLOAT, "n"))));
    assertEquals(
        "global s = request_string_from_primary_client(\"n\")",
        code(node(new ActionStep.OperatorInput("s", InputKind.TEXT, "n"))));
  }

  @Test
  void foldersAndHalts() {
    assertEquals(
        """
        $ 2 "Pick" "noBreak"
        $ 3 "Halt"
        halt
        """,
        body(node(new ActionStep.Folder("Pick"), node(new ActionStep.Halt()))));
  }

  @Test
  void scriptsArePastedAsTheyAre() {
    assertEquals("a = 1\n  b = 2", code(script("a = 1", "  b = 2")));
    assertEquals(
        """
        $ 2 "Script: grip.script"
        def grip():

          sleep(1)
        end
        """,
        body(
            node(
                new ActionStep.ScriptFile(
                    "grip.script", List.of("def grip():", "", "  sleep(1)", "end")))));
  }

  @Test
  void nodesOfOthersRunTheirStubBetweenRemarks() {
    assertEquals(
        """
        $ 2 "Grip: Acme"
        # begin: URCap node Acme: Grip
        grip(1)
        # end: URCap node Acme: Grip
        """,
        body(
            node(
                new ForeignStep.Contributed("Acme", "Grip", List.of("<x/>"), List.of("grip(1)")))));
    assertEquals(
        """
        $ 2 "Unknown: Laser"
        # does nothing: unknown node Laser
        """,
        body(node(new ForeignStep.Unknown("Laser", List.of("<Laser/>")))));
  }

  @Test
  void suppressedNodesGenerateNothing() {
    assertEquals(
        """
        $ 3 "Wait: 2"
        sleep(2.0)
        """,
        body(
            suppressed(sleep(1)),
            sleep(2),
            suppressed(node(new ActionStep.Folder("f"), sleep(3)))));
    String text =
        ScriptGenerator.generate(
                "x",
                tree(once(), suppressed(node(new Section.ThreadSection("T", true), sleep(1)))),
                Installation.NONE)
            .text();
    assertFalse(text.contains("thread"), text);
  }
}
