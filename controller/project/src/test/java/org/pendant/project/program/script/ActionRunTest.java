package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.assign;
import static org.pendant.project.program.script.TestTrees.output;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.say;
import static org.pendant.project.program.script.TestTrees.script;
import static org.pendant.project.program.script.TestTrees.set;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.suppressed;
import static org.pendant.project.program.script.TestTrees.waitFor;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.message.Operator;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.PreparedAnswer;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ActionStep.InputKind;
import org.pendant.project.program.ActionStep.PopupKind;
import org.pendant.project.program.ActionStep.TimerAction;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Setting;
import org.pendant.project.program.WaitFor;
import org.pendant.script.vm.Ending;

/** What nodes do on a controller that neither move nor decide. */
final class ActionRunTest {
  private static final double FRAME_S = 0.002;

  private static ProgramNode popup(String text, PopupKind kind, boolean halts) {
    return node(new ActionStep.Popup(text, false, kind, halts));
  }

  private static ProgramNode timer(TimerAction action) {
    return node(new ActionStep.Timer("Timer_1", action));
  }

  private static TreeRun answered(ProgramTree tree, String... answers) {
    List<PreparedAnswer> prepared = Stream.of(answers).map(PreparedAnswer::new).toList();
    return new TreeRun(
            tree,
            Installation.NONE,
            ControllerOptions.headless().withOperator(Operator.headless(prepared)))
        .finish();
  }

  @Test
  void waitsForATime() {
    assertEquals(0.5, TreeRun.of(program(sleep(0.5))).timeS(), 3 * FRAME_S);
  }

  @Test
  void waitsForALevelOfAnInput() {
    TreeRun run =
        new TreeRun(program(waitFor(new WaitFor.Digital("digital_in[2]", true)), say("high")));
    run.advanceS(1);
    assertEquals(List.of(), run.said());
    run.submit(new IoCommand.SetInput("digital_in[2]", true));
    run.finish();
    assertEquals(List.of("high"), run.said());
  }

  @Test
  void waitsForAnAnalogSignalToPassALevel() {
    ProgramTree tree =
        program(
            script("set_standard_analog_out(0, 1)"),
            node(new ActionStep.Wait(new WaitFor.Analog("analog_out[0]", true, 0.015))),
            say("above"),
            node(new ActionStep.Wait(new WaitFor.Analog("analog_out[0]", false, 0.015))),
            say("below"));
    TreeRun run = new TreeRun(tree).until("above");
    run.advanceS(1);
    assertEquals(List.of("above"), run.said());
  }

  @Test
  void waitsForACondition() {
    TreeRun run = new TreeRun(program(waitFor(new WaitFor.Expression("get_flag(1)")), say("set")));
    run.advanceS(0.1);
    assertTrue(run.running());
    assertEquals(List.of(), run.said());
  }

  @Test
  void setsOutputs() {
    TreeRun run =
        TreeRun.of(
            program(
                output(0, true),
                output(1, true),
                output(1, false),
                set(new Setting.Digital("configurable_out[3]", true)),
                set(new Setting.Digital("tool_out[1]", true)),
                set(new Setting.Expression("digital_out[4]", "1 < 2")),
                set(new Setting.Analog("analog_out[1]", 0.012))));
    assertEquals(0b10001, run.state().io().standardOut());
    assertEquals(0b1000, run.state().io().configurableOut());
    assertEquals(0b10, run.state().io().toolOut());
    assertEquals(0.012, run.state().signals().analog().standardOut1().value(), 1e-9);
  }

  @Test
  void pulsesAreHighForTheirTime() {
    TreeRun run =
        new TreeRun(program(set(new Setting.Pulse("digital_out[0]", 0.2)), say("done"), sleep(1)));
    run.advanceS(0.15);
    assertTrue(run.output(0));
    run.until("done");
    assertFalse(run.output(0));
    assertEquals(0.2, run.timeS(), 4 * FRAME_S);
  }

  @Test
  void declaresPayloadAndTool() {
    TreeRun run =
        TreeRun.of(
            program(
                set(new Setting.Payload(1.5, 0, 0.01, 0.03)),
                set(new Setting.Tcp("", Pose.of(0, 0, 0.1, 0, 0, 0))),
                set(new Setting.Nothing())));
    assertEquals(1.5, run.state().readings().payload().massKg());
    assertEquals(Pose.of(0, 0, 0.1, 0, 0, 0), run.state().arm().tool().inFlange());
  }

  @Test
  void countsUp() {
    TreeRun run = TreeRun.of(program(assign("n", "4"), set(new Setting.Increment("n"))));
    assertEquals("5", run.variable("n"));
  }

  @Test
  void popupsWaitForTheirAnswer() {
    ProgramTree tree =
        program(
            popup("Größe \"3\"", PopupKind.WARNING, false),
            say("on"),
            node(new ActionStep.Popup("str_cat(\"n=\", 3)", true, PopupKind.MESSAGE, false)));
    TreeRun run =
        new TreeRun(
            tree, Installation.NONE, ControllerOptions.headless().withOperator(Operator.present()));
    run.advanceS(0.5);
    assertEquals(List.of(), run.said());
    Popup shown = run.state().openPopups().getFirst();
    assertEquals(TreeRun.bytes("Größe '3'"), shown.text());
    assertEquals(Popup.Severity.WARNING, shown.severity());
    assertTrue(shown.blocking());
    run.submit(new MessageCommand.AnswerPopup(shown.number()));
    run.until("on");
    run.advance(3);
    assertEquals("n=3", run.state().openPopups().getFirst().text());
  }

  @Test
  void haltingPopupsEndTheProgram() {
    TreeRun run =
        TreeRun.of(
            program(
                node(new FlowStep.If("True", false), popup("No part", PopupKind.ERROR, true)),
                say("never")));
    assertEquals(Popup.Severity.ERROR, run.popups().getFirst().severity());
    assertEquals(new Ending.Halted(), run.state().program().ending().orElseThrow());
    assertEquals(List.of(), run.said());
  }

  @Test
  void haltEndsTheProgram() {
    TreeRun run =
        TreeRun.of(
            program(
                say("first"),
                node(new FlowStep.Loop(new LoopRule.Times("3", "")), node(new ActionStep.Halt())),
                sleep(9)));
    assertEquals(new Ending.Halted(), run.state().program().ending().orElseThrow());
    assertEquals(List.of("first"), run.said());
  }

  @Test
  void assignsWhatIsComputed() {
    TreeRun run = TreeRun.of(program(assign("x", "2 + 3"), assign("y", "[x, 1]")));
    assertEquals("5", run.variable("x"));
    assertEquals("[5, 1]", run.variable("y"));
  }

  @Test
  void assignsWhatTheOperatorAnswers() {
    TreeRun run =
        answered(
            program(
                node(new ActionStep.OperatorInput("b", InputKind.BOOLEAN, "Mark \"it\"?")),
                node(new ActionStep.OperatorInput("i", InputKind.INTEGER, "How many?")),
                node(new ActionStep.OperatorInput("f", InputKind.FLOAT, "Offset")),
                node(new ActionStep.OperatorInput("s", InputKind.TEXT, "Name"))),
            "Mark 'it'?=True",
            "How many?=7",
            "Offset=0.5",
            "Name=box");
    assertEquals("True", run.variable("b"));
    assertEquals("7", run.variable("i"));
    assertEquals("0.5", run.variable("f"));
    assertEquals("box", run.variable("s"));
  }

  @Test
  void commentsDoNothingAndFoldersRunInOrder() {
    TreeRun run =
        TreeRun.of(
            program(
                node(new ActionStep.Comment("halt\nhalt")),
                node(
                    new ActionStep.Folder(""),
                    say("a"),
                    node(new ActionStep.Folder("f"), say("b"))),
                say("c")));
    assertEquals(List.of("a", "b", "c"), run.said());
  }

  @Test
  void scriptLinesAndFilesRun() {
    TreeRun run =
        TreeRun.of(
            program(
                node(
                    new ActionStep.ScriptFile(
                        "f.script", List.of("def twice(x):", "  return 2 * x", "end"))),
                script("global four = twice(2)", "textmsg(four)")));
    assertEquals(List.of("4"), run.said());
  }

  @Test
  void stubsOfContributedNodesRunAndUnknownNodesDoNothing() {
    TreeRun run =
        TreeRun.of(
            program(
                node(
                    new ForeignStep.Contributed(
                        "Acme \"x\"", "Grip", List.of("<a>"), List.of("textmsg(\"grip\")"))),
                node(new ForeignStep.Unknown("Laser", List.of("halt")))));
    assertEquals(List.of("grip"), run.said());
  }

  @Test
  void suppressedNodesDoNothing() {
    TreeRun run =
        TreeRun.of(
            program(
                suppressed(node(new ActionStep.Folder("f"), say("a"))),
                suppressed(sleep(9)),
                say("b")));
    assertEquals(List.of("b"), run.said());
    assertTrue(run.timeS() < 1);
  }

  @Test
  void timersCountWhileTheyRun() {
    TreeRun run =
        TreeRun.of(
            program(
                timer(TimerAction.START),
                sleep(0.5),
                timer(TimerAction.STOP),
                sleep(0.5),
                assign("first", "Timer_1"),
                timer(TimerAction.RESET),
                timer(TimerAction.START),
                sleep(0.25),
                timer(TimerAction.STOP)));
    assertEquals(0.5, Double.parseDouble(run.variable("first")), 3 * FRAME_S);
    assertEquals(0.25, Double.parseDouble(run.variable("Timer_1")), 3 * FRAME_S);
  }
}
