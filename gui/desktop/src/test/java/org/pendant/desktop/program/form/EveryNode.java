package org.pendant.desktop.program.form;

import static org.pendant.project.program.ProgramTree.node;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.NamedTool;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
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
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.UntilRule;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

/** A program with a node of every kind, and an installation for it. */
final class EveryNode {
  private EveryNode() {}

  private static final MotionStep.Move JOINT_MOVE =
      new MotionStep.Move(
          MoveKind.JOINT,
          Math.toRadians(60),
          Math.toRadians(80),
          new ToolChoice.Active(),
          "Base",
          false);

  private static MotionStep.Move tool(MoveKind kind) {
    return new MotionStep.Move(kind, 0.25, 1.2, new ToolChoice.Named("Gripper"), "Table", false);
  }

  private static ProgramNode waypoint(WaypointTarget target, Timing timing, double blendM) {
    return node(
        new MotionStep.Waypoint(
            target, timing, blendM > 0 ? OptionalDouble.of(blendM) : OptionalDouble.empty()));
  }

  private static ProgramNode fixed(String name) {
    return waypoint(new WaypointTarget.Fixed(name), new Timing.AsMove(), 0);
  }

  private static List<ProgramNode> motion() {
    return List.of(
        node(
            JOINT_MOVE,
            fixed("Waypoint_1"),
            waypoint(new WaypointTarget.Fixed("Waypoint_2"), new Timing.Own(0.5, 1), 0.02),
            fixed("Waypoint_3"),
            fixed("Far")),
        node(
            tool(MoveKind.LINEAR),
            waypoint(
                new WaypointTarget.Relative("Up", "Waypoint_1", "Up_to"),
                new Timing.Duration(1.5),
                0),
            waypoint(new WaypointTarget.Variable("pick_pose"), new Timing.AsMove(), 0),
            fixed("Waypoint_1"),
            node(
                new MotionStep.Direction(
                    "Base", 0, 0, -1, OptionalDouble.of(0.05), OptionalDouble.empty()),
                node(new MotionStep.Until(new UntilRule.Distance(0.1))),
                node(new MotionStep.Until(new UntilRule.Contact(0.005, 3))),
                node(new MotionStep.Until(new UntilRule.Expression("force() > 20"))),
                node(new MotionStep.Until(new UntilRule.DigitalInput("digital_in[0]", true))))),
        node(
            new MotionStep.Move(
                MoveKind.PROCESS, 0.1, 1.2, new ToolChoice.Named("Lost"), "Lost_frame", false),
            node(
                new MotionStep.CircleMove(true, OptionalDouble.empty()),
                fixed("Waypoint_1"),
                fixed("Waypoint_2"))),
        node(new MotionStep.Home(Math.toRadians(60), Math.toRadians(80), OptionalDouble.empty())));
  }

  private static List<ProgramNode> actions() {
    List<ProgramNode> all = new ArrayList<>();
    for (WaitFor each :
        List.of(
            new WaitFor.Nothing(),
            new WaitFor.Time(0.5),
            new WaitFor.Digital("digital_in[1]", true),
            new WaitFor.Analog("analog_in[0]", true, 5),
            new WaitFor.Expression("count > 3 and unknown_thing"))) {
      all.add(node(new ActionStep.Wait(each)));
    }
    for (Setting each :
        List.of(
            new Setting.Nothing(),
            new Setting.Digital("digital_out[0]", true),
            new Setting.Analog("analog_out[0]", 0.01),
            new Setting.Pulse("digital_out[1]", 0.5),
            new Setting.Expression("digital_out[2]", "count > 3"),
            new Setting.NamedPayload("Part"),
            new Setting.Payload(1.25, 0, 0, 0.05),
            new Setting.Tcp("", new Pose(0, 0, 0.12, 0, 0, 0)),
            new Setting.Increment("parts"))) {
      all.add(node(new ActionStep.SetAction(each)));
    }
    all.add(
        node(
            new ActionStep.Popup(
                "The feeder is empty. Fill it, then press Continue.",
                false,
                ActionStep.PopupKind.WARNING,
                false)));
    all.add(node(new ActionStep.Popup("count", true, ActionStep.PopupKind.ERROR, true)));
    all.add(node(new ActionStep.Halt()));
    all.add(node(new ActionStep.Comment("Takes a part from the feeder")));
    all.add(node(new ActionStep.Folder("Pick"), node(new ActionStep.Halt())));
    all.add(node(new ActionStep.Assignment("count", "count + 1")));
    all.add(
        node(
            new ActionStep.OperatorInput(
                "batch", ActionStep.InputKind.INTEGER, "How many parts?")));
    all.add(node(new ActionStep.Call("Pick")));
    all.add(node(new ActionStep.ScriptLine("global speed_now = norm(get_actual_tcp_speed())")));
    all.add(
        node(
            new ActionStep.ScriptFile(
                "gripper.script",
                List.of(
                    "def grip(width):",
                    "  # closes the gripper",
                    "  set_tool_digital_out(0, True)",
                    "  sleep(0.5)",
                    "end"))));
    all.add(node(new ActionStep.Timer("cycle", ActionStep.TimerAction.START)));
    return all;
  }

  private static List<ProgramNode> flow() {
    return List.of(
        node(new FlowStep.If("get_standard_digital_in(0)", true)),
        node(new FlowStep.ElseIf("count > 5")),
        node(new FlowStep.Else()),
        node(new FlowStep.Loop(new LoopRule.Forever())),
        node(new FlowStep.Loop(new LoopRule.Times("5", "turn"))),
        node(new FlowStep.Loop(new LoopRule.While("count < 10", true))),
        node(
            new FlowStep.Switch("batch"),
            node(new FlowStep.Case("1")),
            node(new FlowStep.DefaultCase())));
  }

  private static List<ProgramNode> templates() {
    List<ProgramNode> all = new ArrayList<>();
    for (Pattern each :
        List.of(
            new Pattern.Line("Waypoint_1", "", 5),
            new Pattern.Square(List.of("Waypoint_1", "Waypoint_2", "", ""), 4, 3),
            new Pattern.Box(List.of("", "", "", "", "", "", "", ""), 4, 3, 3),
            new Pattern.Places(List.of("Waypoint_1", "Waypoint_2", "Waypoint_3")))) {
      all.add(node(new TemplateStep.Palletizing("pallet", each, "Base", true)));
    }
    for (TemplateStep.PatternRole each : TemplateStep.PatternRole.values()) {
      all.add(
          node(
              new TemplateStep.PatternPoint(
                  each, "Waypoint_1", MoveKind.LINEAR, 0.25, 1.2, OptionalDouble.empty())));
    }
    all.add(node(new TemplateStep.Part(TemplateStep.PartKind.SEQUENCE)));
    all.add(
        node(
            new TemplateStep.Seek(
                true,
                "stack",
                "Waypoint_1",
                "Base",
                List.of(0.0, 0.0, -1.0),
                0.3,
                0.02,
                "force() > 15",
                0.05,
                1.2)));
    for (TemplateStep.ForceKind each : TemplateStep.ForceKind.values()) {
      all.add(
          node(
              new TemplateStep.Force(
                  each,
                  "Base",
                  List.of(false, false, true, false, true, false),
                  List.of(0.0, 0.0, -20.0, 0.0, 0.0, 0.0),
                  List.of(0.05, 0.05, 0.1, 0.2, 0.2, 0.2))));
    }
    all.add(
        node(
            new TemplateStep.Screwdriving(
                new ToolChoice.Named("Gripper"),
                true,
                20,
                false,
                "digital_out[0]",
                "get_standard_digital_in(0)",
                5)));
    all.add(node(new TemplateStep.ConveyorTracking(1)));
    all.add(node(new TemplateStep.ConveyorTracking(2)));
    return all;
  }

  private static List<ProgramNode> foreign() {
    return List.of(
        node(
            new ForeignStep.Contributed(
                "com.example.gripper",
                "GripNode",
                List.of("<data>", "  <width>42</width>", "</data>"),
                List.of("set_tool_digital_out(0, True)", "sleep(0.5)"))),
        node(
            new ForeignStep.Unknown(
                "WeldNode", List.of("<WeldNode speed=\"3\">", "  <arc/>", "</WeldNode>"))));
  }

  /** The program; the arm of {@code state} stands at its first places. */
  static ProgramTree tree(ControllerState state) {
    ProgramTree tree = ProgramTree.empty();
    long main = tree.sections().getFirst().key();
    List<ProgramNode> all = new ArrayList<>(motion());
    all.addAll(actions());
    all.addAll(flow());
    all.addAll(templates());
    all.addAll(foreign());
    tree =
        tree.insert(main, 0, all)
            .insert(
                ProgramTree.ROOT,
                0,
                List.of(
                    node(
                        new Section.InitialValues(
                            List.of(
                                new Section.InitialValue("count", "0"),
                                new Section.InitialValue("pick_pose", "p[0.3, 0, 0.2, 0, 3.14, 0]"),
                                new Section.InitialValue("2wrong", "1 +")))),
                    node(new Section.BeforeStart())))
            .insert(
                ProgramTree.ROOT,
                3,
                List.of(
                    node(new Section.ThreadSection("Watch gripper", true)),
                    node(new Section.Event("get_standard_digital_in(3)")),
                    node(new Section.SubProgram("Pick", "pick.pendant"))));
    return tree.withWaypoints(places(state));
  }

  private static Map<String, WaypointPosition> places(ControllerState state) {
    WaypointPosition here = Taught.here(state, Installation.NONE, "Base");
    Map<String, WaypointPosition> places = new LinkedHashMap<>();
    places.put("Waypoint_1", here);
    places.put("Waypoint_2", here);
    Joints far = here.jointsRad().with(0, Math.toRadians(357));
    places.put("Far", Taught.withJoints(here, far, state.arm().description(), Installation.NONE));
    return places;
  }

  /** An installation with something of everything. */
  static Installation installation() {
    Installation none = Installation.NONE;
    return new Installation(
        none.robot(),
        none.calibration(),
        List.of(
            new NamedTool("Gripper", new Pose(0, 0, 0.12, 0, 0, 0)),
            new NamedTool("Bit", new Pose(0.05, 0, 0.2, 0, 0, 0))),
        "Gripper",
        List.of(new NamedPayload("Part", 0.8, new Vector3(0, 0, 0.05), Inertia.NONE)),
        "",
        none.mounting(),
        List.of(
            new SignalUse(
                "digital_in[0]", "Part there", InputAction.DEFAULT, RunStateAction.PRESERVE),
            new SignalUse(
                "digital_out[0]", "Close gripper", InputAction.DEFAULT, RunStateAction.PRESERVE)),
        none.wiring(),
        List.of(
            new Feature(
                "Table", FeatureKind.POINT, List.of(new Pose(0.2, 0.1, 0, 0, 0, 0)), true, true)),
        none.homeRad(),
        List.of(new InstallationVariable("parts", "0", true)),
        none.startUp(),
        none.safety(),
        List.of(new ConveyorSetup(1, 0, "Table", false, 20_000, false, 1, List.of(0, 1))),
        none.modbus(),
        none.ethernetIpLoss(),
        1,
        none.controlHost());
  }
}
