package org.pendant.project.program.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.Pattern;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Setting;
import org.pendant.project.program.Step;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.text.RandomTrees;

/** What is written is read again as it was. */
@Tag("slow")
class UrpRoundTripTest {
  private static final WaypointPosition PLACE =
      new WaypointPosition(
          new Pose(0.1, -0.3, 0.2, 0, 3.14, 0),
          "Table",
          new Joints(0, -1.5, -1.5, -1.5, 1.5, 0),
          new Pose(0, 0, 0.15, 0, 0, 0));

  private static ProgramTree again(ProgramTree tree) throws UnreadableFile {
    return UrpPrograms.read("again.urp", UrpPrograms.write("again", tree)).tree();
  }

  private static ProgramTree tree(ProgramNode... sections) {
    return new ProgramTree("cell", Map.of("P", PLACE, "Q", PLACE), List.of(), 1)
        .insert(ProgramTree.ROOT, 0, List.of(sections));
  }

  private static ProgramNode node(Step step, ProgramNode... children) {
    return ProgramTree.node(step, children);
  }

  private static ProgramNode waypoint(WaypointTarget target, Timing timing, double blendM) {
    OptionalDouble blend = blendM < 0 ? OptionalDouble.empty() : OptionalDouble.of(blendM);
    return node(new MotionStep.Waypoint(target, timing, blend));
  }

  private static MotionStep.Move move(MoveKind kind, ToolChoice tool, String feature) {
    return new MotionStep.Move(kind, 0.25, 1.2, tool, feature, kind == MoveKind.JOINT);
  }

  private static ProgramTree everything() {
    WaypointTarget p = new WaypointTarget.Fixed("P");
    List<ProgramNode> nodes = new ArrayList<>();
    nodes.add(
        node(
            move(MoveKind.JOINT, new ToolChoice.Active(), "Base"),
            waypoint(p, new Timing.AsMove(), -1),
            waypoint(p, new Timing.Own(1.5, 2), 0.02),
            waypoint(new WaypointTarget.Variable("spot"), new Timing.Duration(2.5), -1),
            waypoint(new WaypointTarget.Variable("a[2]"), new Timing.AsMove(), -1)));
    nodes.add(
        node(
            move(MoveKind.PROCESS, new ToolChoice.Named("Grip"), "Table"),
            waypoint(new WaypointTarget.Fixed("Q"), new Timing.Own(0.1, 1), 0.01),
            node(
                new MotionStep.CircleMove(true, OptionalDouble.of(0.005)),
                waypoint(p, new Timing.AsMove(), -1),
                waypoint(new WaypointTarget.Fixed("untaught"), new Timing.AsMove(), -1))));
    nodes.add(
        node(
            move(MoveKind.LINEAR, new ToolChoice.Flange(), "Tool"),
            waypoint(new WaypointTarget.Relative("R", "R_from", "R_to"), new Timing.AsMove(), -1),
            node(
                new MotionStep.Direction(
                    "Base", 0, 0, -1, OptionalDouble.of(0.1), OptionalDouble.empty()),
                node(
                    new MotionStep.Until(new UntilRule.Distance(0.1)),
                    node(new ActionStep.Comment("far"))),
                node(new MotionStep.Until(new UntilRule.Contact(0.01, 3))),
                node(new MotionStep.Until(new UntilRule.Expression("x > 1"))),
                node(new MotionStep.Until(new UntilRule.DigitalInput("tool_in[1]", true))))));
    for (Step each :
        List.of(
            new MotionStep.Home(1, 1.4, OptionalDouble.empty()),
            new MotionStep.Home(1, 1.4, OptionalDouble.of(3)),
            new ActionStep.Wait(new WaitFor.Nothing()),
            new ActionStep.Wait(new WaitFor.Time(0.5)),
            new ActionStep.Wait(new WaitFor.Digital("configurable_in[3]", true)),
            new ActionStep.Wait(new WaitFor.Analog("analog_in[1]", false, 4.5)),
            new ActionStep.Wait(new WaitFor.Expression("a == \"\u225f <&>\" and not b")),
            new ActionStep.SetAction(new Setting.Nothing()),
            new ActionStep.SetAction(new Setting.Digital("digital_out[7]", false)),
            new ActionStep.SetAction(new Setting.Analog("analog_out[0]", 0.012)),
            new ActionStep.SetAction(new Setting.Pulse("digital_out[1]", 0.5)),
            new ActionStep.SetAction(new Setting.Expression("tool_out[0]", "i > 3")),
            new ActionStep.SetAction(new Setting.NamedPayload("Box")),
            new ActionStep.SetAction(new Setting.Payload(1.5, 0, 0.01, 0.05)),
            new ActionStep.SetAction(new Setting.Tcp("Grip", Pose.ZERO)),
            new ActionStep.SetAction(new Setting.Tcp("", new Pose(0, 0, 0.1, 0, 0, 0))),
            new ActionStep.SetAction(new Setting.Increment("n")),
            new ActionStep.Popup("line 1\nsays \"no\"", false, ActionStep.PopupKind.ERROR, true),
            new ActionStep.Popup("note", true, ActionStep.PopupKind.WARNING, false),
            new ActionStep.Popup("to_str(3)", true, ActionStep.PopupKind.MESSAGE, false),
            new ActionStep.Halt(),
            new ActionStep.Assignment("i", "i + 1"),
            new ActionStep.Assignment("", ""),
            new ActionStep.OperatorInput("n", ActionStep.InputKind.INTEGER, "How many?"),
            new ActionStep.Call("Pick"),
            new ActionStep.Call("Pick"),
            new ActionStep.Call("missing"),
            new ActionStep.ScriptLine("textmsg(\"a\", 1)"),
            new ActionStep.ScriptFile("grip.script", List.of("if a:", "  b()", "", "end")),
            new ActionStep.ScriptFile("", List.of()),
            new ActionStep.Timer("t", ActionStep.TimerAction.RESET),
            new FlowStep.If("a < 3", true),
            new FlowStep.ElseIf("a > 5"),
            new FlowStep.Else(),
            new FlowStep.Loop(new LoopRule.Forever()),
            new FlowStep.Loop(new LoopRule.Times("3", "")),
            new FlowStep.Loop(new LoopRule.Times("n", "Loop_2")),
            new FlowStep.Loop(new LoopRule.While("a", true)),
            new TemplateStep.Palletizing("Box", new Pattern.Line("P", "Q", 4), "Base", true),
            new TemplateStep.ConveyorTracking(2),
            new ForeignStep.Unknown("Weld", List.of("<Weld a='1'>", "  <b/>", "</Weld>")),
            new ForeignStep.Unknown("Broken", List.of("<Broken>")),
            new ForeignStep.Contributed(
                "ACME",
                "Grip",
                List.of(
                    "<Contributed strategyURCapDeveloper=\"ACME\""
                        + " strategyProgramNodeType=\"Grip\"/>"),
                List.of("grip()", "", "# done -- really")))) {
      nodes.add(node(each));
    }
    nodes.add(
        node(
            new FlowStep.Switch("i"),
            node(new FlowStep.Case("1")),
            node(new FlowStep.DefaultCase(), node(new ActionStep.Halt()))));
    nodes.add(
        node(new ActionStep.Folder("F"), node(new ActionStep.Comment("# --> \u4e2d \ud83d\ude00")))
            .withSuppressed(true));
    return tree(
        node(
            new Section.InitialValues(
                List.of(
                    new Section.InitialValue("i", "0"), new Section.InitialValue("spot", "P_p")))),
        node(new Section.BeforeStart(), node(new ActionStep.Wait(new WaitFor.Time(1)))),
        node(new Section.MainProgram(false), nodes.toArray(ProgramNode[]::new)),
        node(new Section.ThreadSection("Thread 1", false), node(new ActionStep.Halt())),
        node(new Section.Event("i > 3"), node(new ActionStep.Comment("e"))),
        node(
            new Section.SubProgram("Pick", "pick.urp"),
            node(new ActionStep.Call("Pick")),
            node(new ActionStep.Comment("sub"))));
  }

  @Test
  void keepsEveryKindOfNode() throws UnreadableFile {
    ProgramTree tree = everything();
    assertEquals(tree, again(tree));
  }

  @Test
  void writesInOurOwnFormOnlyWhatHasNoOther() throws UnreadableFile {
    List<String> own = UrpPrograms.ownForms("x", everything(), Installation.NONE);
    assertEquals(
        List.of(
            "Waypoint",
            "Direction",
            "Set",
            "Set",
            "Set",
            "Set",
            "Popup",
            "Operator input",
            "Palletizing",
            "Conveyor tracking",
            "Unknown"),
        own.stream().map(each -> each.substring(each.indexOf(", ") + 2)).toList());
  }

  @Test
  void keepsEveryKindOfNodeSuppressedInTheFormOfPolyScope() throws UnreadableFile {
    ProgramTree tree = everything();
    int own = UrpPrograms.ownForms("x", tree, Installation.NONE).size();
    for (ProgramNode each : tree.nodes()) {
      if (!(each.step() instanceof Section.MainProgram)) {
        ProgramTree off = tree.withNode(each.key(), node -> node.withSuppressed(true));
        assertEquals(off, again(off), each.step().toString());
        assertEquals(off, ProgramText.read(ProgramText.write(off)).tree(), each.step().toString());
        assertEquals(own, UrpPrograms.ownForms("x", off, Installation.NONE).size());
      }
    }
  }

  @Test
  void aSuppressedNodeIsWrittenByItsClass() throws UnreadableFile {
    ForeignStep weld =
        new ForeignStep.Unknown(
            "Weld", List.of("<Weld a=' class=\"b\"'>", "<Weld></Weld>", "</Weld >"));
    ForeignStep classy = new ForeignStep.Unknown("Glue", List.of("<Glue class=\"b\"/>"));
    ProgramTree off =
        tree(
            node(
                new Section.MainProgram(false),
                node(new ActionStep.Folder("f"), node(new ActionStep.Halt())).withSuppressed(true),
                node(weld).withSuppressed(true),
                node(classy).withSuppressed(true)),
            node(new Section.ThreadSection("T", true)).withSuppressed(true),
            node(new Section.SubProgram("S", "")).withSuppressed(true));
    String xml = new UrpProgramWriter("x", off, Installation.NONE).write();
    for (String part :
        List.of(
            "<suppressedNode class=\"Folder\" name=\"f\">",
            "<suppressedNode class=\"Weld\" a=' class=\"b\"'>\n<Weld></Weld>\n</suppressedNode >",
            "<Glue class=\"b\"/>",
            "<suppressedNode class=\"Thread\" name=\"T\"",
            "<suppressedNode class=\"SubProgram\" name=\"S\"")) {
      assertTrue(xml.contains(part), part + " is missing in " + xml);
    }
    assertEquals(off, again(off));
  }

  @Test
  void aForeignNodeThatIsUsedAgainIsWrittenAsItIsCalled() throws UnreadableFile {
    String xml =
        """
        <URProgram name="x"><children><MainProgram><children>
        <SuppressedNode><suppressedNode speed="1" class = 'Weld' on="x"><a/></suppressedNode></SuppressedNode>
        </children></MainProgram></children></URProgram>
        """;
    ProgramTree read =
        UrpPrograms.read("x.urp", xml.getBytes(StandardCharsets.UTF_8)).tree().renumbered();
    long key = read.nodes().getLast().key();
    ProgramTree used = read.withNode(key, node -> node.withSuppressed(false));
    String written = new UrpProgramWriter("x", used, Installation.NONE).write();
    assertTrue(written.contains("<Weld speed=\"1\" on=\"x\"><a/></Weld>"), written);
    assertFalse(written.contains("uppressedNode"), written);
    assertEquals(read, again(read));
  }

  @Test
  void keepsTreesWithAnythingInTheirFields() throws UnreadableFile {
    for (int seed = 0; seed < 200; seed++) {
      ProgramTree tree = new RandomTrees(seed).tree();
      assertEquals(tree, again(tree), "seed " + seed);
    }
  }

  @Test
  void keepsDeepTreesAndLongChainsOfSubPrograms() throws UnreadableFile {
    ProgramNode deep = node(new ActionStep.Halt());
    for (int i = 0; i < 199; i++) {
      deep = node(new ActionStep.Folder("f"), deep);
    }
    List<ProgramNode> sections = new ArrayList<>();
    sections.add(node(new Section.MainProgram(true), deep, node(new ActionStep.Call("s0"))));
    for (int i = 0; i < 500; i++) {
      sections.add(
          node(
              new Section.SubProgram("s" + i, ""), node(new ActionStep.Call("s" + (i + 1) % 500))));
    }
    ProgramTree tree = tree(sections.toArray(ProgramNode[]::new));
    assertEquals(tree, again(tree));
  }

  @Test
  void writesTheSameFileForTheSameTree() {
    byte[] once = UrpPrograms.write("x", everything());
    byte[] twice = UrpPrograms.write("x", everything());
    assertEquals(
        new String(once, StandardCharsets.ISO_8859_1),
        new String(twice, StandardCharsets.ISO_8859_1));
  }

  @Test
  void writesAProgramOfTwoThousandNodes() throws UnreadableFile {
    List<ProgramNode> nodes = new ArrayList<>();
    for (int i = 0; i < 2000; i++) {
      nodes.add(node(new ActionStep.Assignment("v" + i % 7, "v" + (i + 1) % 7 + " + 1")));
    }
    ProgramTree tree = tree(node(new Section.MainProgram(true), nodes.toArray(ProgramNode[]::new)));
    assertEquals(tree, again(tree));
    assertTrue(UrpPrograms.ownForms("x", tree, Installation.NONE).isEmpty());
  }
}
