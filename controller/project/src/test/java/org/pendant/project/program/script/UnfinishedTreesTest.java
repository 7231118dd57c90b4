package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.project.program.ProgramTree.node;
import static org.pendant.project.program.script.TestTrees.once;
import static org.pendant.project.program.script.TestTrees.tree;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.installation.Installation;
import org.pendant.language.source.Source;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ActionStep.InputKind;
import org.pendant.project.program.ActionStep.PopupKind;
import org.pendant.project.program.ActionStep.TimerAction;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.Pattern;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Section;
import org.pendant.project.program.Setting;
import org.pendant.project.program.Step;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointTarget;
import org.pendant.script.vm.ProgramLoader;

/** Scripts of trees that nobody has filled in yet. */
final class UnfinishedTreesTest {
  private static final OptionalDouble NONE = OptionalDouble.empty();

  private static final List<Step> EMPTY =
      List.of(
          new MotionStep.Waypoint(new WaypointTarget.Fixed(""), new Timing.AsMove(), NONE),
          new MotionStep.Waypoint(
              new WaypointTarget.Relative("", "", ""), new Timing.AsMove(), NONE),
          new MotionStep.Waypoint(new WaypointTarget.Variable(""), new Timing.AsMove(), NONE),
          new MotionStep.CircleMove(false, NONE),
          new MotionStep.Direction("", 0, 0, 0, NONE, NONE),
          new MotionStep.Until(new UntilRule.Expression("")),
          new ActionStep.Wait(new WaitFor.Digital("", true)),
          new ActionStep.Wait(new WaitFor.Analog("", true, 0)),
          new ActionStep.Wait(new WaitFor.Expression("")),
          new ActionStep.SetAction(new Setting.Digital("", true)),
          new ActionStep.SetAction(new Setting.Analog("", 0)),
          new ActionStep.SetAction(new Setting.Pulse("", 1)),
          new ActionStep.SetAction(new Setting.Expression("digital_out[0]", "")),
          new ActionStep.SetAction(new Setting.NamedPayload("")),
          new ActionStep.SetAction(new Setting.Tcp("", Pose.ZERO)),
          new ActionStep.SetAction(new Setting.Increment("")),
          new ActionStep.Popup("", true, PopupKind.MESSAGE, false),
          new ActionStep.Popup("", false, PopupKind.MESSAGE, false),
          new ActionStep.Comment(""),
          new ActionStep.Folder(""),
          new ActionStep.Assignment("", ""),
          new ActionStep.OperatorInput("", InputKind.TEXT, ""),
          new ActionStep.Call(""),
          new ActionStep.ScriptLine(""),
          new ActionStep.ScriptFile("", List.of()),
          new ActionStep.Timer("", TimerAction.START),
          new FlowStep.If("", false),
          new FlowStep.If("", true),
          new FlowStep.ElseIf(""),
          new FlowStep.Else(),
          new FlowStep.Loop(new LoopRule.Times("", "")),
          new FlowStep.Loop(new LoopRule.While("", false)),
          new FlowStep.Loop(new LoopRule.While("", true)),
          new FlowStep.Switch(""),
          new FlowStep.Case(""),
          new FlowStep.DefaultCase(),
          new TemplateStep.Palletizing("", new Pattern.Line("", "", 0), "", false),
          new TemplateStep.Palletizing("", new Pattern.Square(List.of(), 0, 0), "", true),
          new TemplateStep.Palletizing("", new Pattern.Box(List.of(), 0, 0, 0), "", true),
          new TemplateStep.Palletizing("", new Pattern.Places(List.of()), "", true),
          new TemplateStep.Seek(true, "", "", "", List.of(), 0, 0, "", 0, 0),
          new TemplateStep.Force(
              TemplateStep.ForceKind.SIMPLE, "", List.of(), List.of(), List.of()),
          new TemplateStep.ConveyorTracking(0),
          new ForeignStep.Contributed("", "", List.of(), List.of()),
          new ForeignStep.Unknown("", List.of()));

  private static void assertLoads(ProgramNode... sections) {
    String text = ScriptGenerator.generate("", tree(sections), Installation.NONE).text();
    assertEquals(
        List.of(),
        TestTrees.unexpected(
            ProgramLoader.load(Source.of("empty", text), StandardBuiltins.create())),
        text);
  }

  @Test
  void nodesThatAreNotFilledInGenerateNothingThatFails() {
    for (Step step : EMPTY) {
      assertLoads(once(node(step)));
      assertLoads(
          once(
              node(
                  new MotionStep.Move(MoveKind.LINEAR, 0, 0, new ToolChoice.Named(""), "", false),
                  node(step))));
    }
  }

  @Test
  void sectionsThatAreNotFilledInGenerateNothingThatFails() {
    assertLoads(
        node(new Section.InitialValues(List.of(new Section.InitialValue("", "")))),
        node(new Section.BeforeStart()),
        node(new Section.MainProgram(true)),
        node(new Section.ThreadSection("", true)),
        node(new Section.ThreadSection("", false)),
        node(new Section.Event("")),
        node(new Section.SubProgram("", "")));
    assertLoads();
  }
}
