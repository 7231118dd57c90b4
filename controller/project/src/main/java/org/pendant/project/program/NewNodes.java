package org.pendant.project.program;

import static org.pendant.project.program.ProgramTree.node;

import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import org.pendant.project.program.ActionStep.InputKind;
import org.pendant.project.program.ActionStep.PopupKind;
import org.pendant.project.program.ActionStep.TimerAction;
import org.pendant.project.program.MotionStep.CircleMove;
import org.pendant.project.program.MotionStep.Direction;
import org.pendant.project.program.MotionStep.Home;
import org.pendant.project.program.MotionStep.Move;
import org.pendant.project.program.MotionStep.Until;
import org.pendant.project.program.MotionStep.Waypoint;
import org.pendant.project.program.TemplateStep.ForceKind;
import org.pendant.project.program.TemplateStep.PartKind;
import org.pendant.project.program.TemplateStep.PatternPoint;
import org.pendant.project.program.TemplateStep.PatternRole;

/**
 * Makes nodes as a palette adds them: with the values that a robot's own screen begins with, and
 * with the nodes below them that they cannot do without. Names are such that the tree does not have
 * yet.
 */
public final class NewNodes {
  private static final double JOINT_SPEED_RAD_PER_S = Math.toRadians(60);
  private static final double JOINT_ACCELERATION_RAD_PER_S2 = Math.toRadians(80);
  private static final double TOOL_SPEED_M_PER_S = 0.25;
  private static final double TOOL_ACCELERATION_M_PER_S2 = 1.2;
  private static final double SEEK_SPEED_M_PER_S = 0.05;
  private static final double PRESSING_N = 20;

  private final Set<String> taken;

  private NewNodes(ProgramTree tree) {
    taken = new HashSet<>(TreeNames.all(tree));
  }

  /**
   * A node of a kind that can be added, for a tree.
   *
   * @throws IllegalArgumentException if nodes of that kind cannot be added
   */
  public static ProgramNode of(NodeKind kind, ProgramTree tree) {
    return new NewNodes(tree).make(kind);
  }

  private ProgramNode make(NodeKind kind) {
    return switch (kind) {
      case MOVE_JOINT -> node(move(MoveKind.JOINT), waypoint());
      case MOVE_LINEAR -> node(move(MoveKind.LINEAR), waypoint());
      case MOVE_PROCESS -> node(move(MoveKind.PROCESS), waypoint());
      case WAYPOINT -> waypoint();
      case DIRECTION -> direction();
      case UNTIL -> until();
      case CIRCLE_MOVE ->
          node(new CircleMove(false, OptionalDouble.empty()), waypoint(), waypoint());
      case HOME ->
          node(
              new Home(
                  JOINT_SPEED_RAD_PER_S, JOINT_ACCELERATION_RAD_PER_S2, OptionalDouble.empty()));
      case WAIT -> node(new ActionStep.Wait(new WaitFor.Time(0.01)));
      case SET -> node(new ActionStep.SetAction(new Setting.Nothing()));
      case POPUP -> node(new ActionStep.Popup("", false, PopupKind.MESSAGE, false));
      case HALT -> node(new ActionStep.Halt());
      case COMMENT -> node(new ActionStep.Comment(""));
      case FOLDER -> node(new ActionStep.Folder("Folder"));
      case LOOP -> node(new FlowStep.Loop(new LoopRule.Forever()));
      case CALL -> node(new ActionStep.Call(""));
      case ASSIGNMENT -> node(new ActionStep.Assignment(name("var"), ""));
      case OPERATOR_INPUT -> node(new ActionStep.OperatorInput(name("var"), InputKind.INTEGER, ""));
      case IF -> node(new FlowStep.If("", false));
      case ELSE_IF -> node(new FlowStep.ElseIf(""));
      case ELSE -> node(new FlowStep.Else());
      case SWITCH ->
          node(
              new FlowStep.Switch(""),
              node(new FlowStep.Case("1")),
              node(new FlowStep.DefaultCase()));
      case CASE -> node(new FlowStep.Case(""));
      case DEFAULT_CASE -> node(new FlowStep.DefaultCase());
      case SCRIPT_LINE -> node(new ActionStep.ScriptLine(""));
      case SCRIPT_FILE -> node(new ActionStep.ScriptFile("", List.of()));
      case TIMER -> node(new ActionStep.Timer(name("timer"), TimerAction.START));
      case PALLETIZING -> palletizing();
      case APPROACH -> point(PatternRole.APPROACH);
      case PATTERN_POINT -> point(PatternRole.POINT);
      case EXIT -> point(PatternRole.EXIT);
      case PART_BEFORE -> part(PartKind.BEFORE_START);
      case PART_AFTER -> part(PartKind.AFTER_END);
      case PART_SEQUENCE -> part(PartKind.SEQUENCE);
      case STACK -> seek(false);
      case DESTACK -> seek(true);
      case FORCE -> force();
      case SCREWDRIVING ->
          node(
              new TemplateStep.Screwdriving(
                  new ToolChoice.Active(), true, PRESSING_N, false, "", "", 0));
      case CONVEYOR_TRACKING -> node(new TemplateStep.ConveyorTracking(1));
      case INITIAL_VALUES -> node(new Section.InitialValues(List.of()));
      case BEFORE_START -> node(new Section.BeforeStart());
      case THREAD -> node(new Section.ThreadSection(name("Thread"), true));
      case EVENT -> node(new Section.Event(""));
      case SUB_PROGRAM -> node(new Section.SubProgram(name("SubProgram"), ""));
      case MAIN_PROGRAM, CONTRIBUTED, UNKNOWN ->
          throw new IllegalArgumentException(kind.title() + " cannot be added");
    };
  }

  private static Move move(MoveKind kind) {
    boolean joint = kind == MoveKind.JOINT;
    return new Move(
        kind,
        joint ? JOINT_SPEED_RAD_PER_S : TOOL_SPEED_M_PER_S,
        joint ? JOINT_ACCELERATION_RAD_PER_S2 : TOOL_ACCELERATION_M_PER_S2,
        new ToolChoice.Active(),
        WaypointPosition.BASE,
        false);
  }

  private ProgramNode waypoint() {
    return node(
        new Waypoint(
            new WaypointTarget.Fixed(name("Waypoint")),
            new Timing.AsMove(),
            OptionalDouble.empty()));
  }

  /** Down, for a hundred millimetres. */
  private static ProgramNode direction() {
    return node(
        new Direction(
            WaypointPosition.BASE, 0, 0, -1, OptionalDouble.empty(), OptionalDouble.empty()),
        until());
  }

  private static ProgramNode until() {
    return node(new Until(new UntilRule.Distance(0.1)));
  }

  private ProgramNode palletizing() {
    return node(
        new TemplateStep.Palletizing(
            name("Pallet"),
            new Pattern.Line(name("StartItem"), name("EndItem"), 4),
            WaypointPosition.BASE,
            false),
        point(PatternRole.APPROACH),
        point(PatternRole.POINT),
        point(PatternRole.EXIT));
  }

  private ProgramNode point(PatternRole role) {
    String start =
        switch (role) {
          case APPROACH -> "Approach";
          case POINT -> "PatternPoint";
          case EXIT -> "Exit";
        };
    return node(
        new PatternPoint(
            role,
            name(start),
            MoveKind.LINEAR,
            TOOL_SPEED_M_PER_S,
            TOOL_ACCELERATION_M_PER_S2,
            OptionalDouble.empty()));
  }

  private static ProgramNode part(PartKind kind) {
    return node(new TemplateStep.Part(kind));
  }

  private ProgramNode seek(boolean destack) {
    return node(
        new TemplateStep.Seek(
            destack,
            name(destack ? "Destack" : "Stack"),
            name("StartPos"),
            WaypointPosition.BASE,
            List.of(0.0, 0.0, -1.0),
            0.3,
            0.02,
            "",
            SEEK_SPEED_M_PER_S,
            TOOL_ACCELERATION_M_PER_S2),
        part(PartKind.SEQUENCE));
  }

  private static ProgramNode force() {
    double turnLimit = Math.toRadians(20);
    return node(
        new TemplateStep.Force(
            ForceKind.SIMPLE,
            WaypointPosition.TOOL,
            List.of(false, false, true, false, false, false),
            List.of(0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
            List.of(0.1, 0.1, 0.15, turnLimit, turnLimit, turnLimit)));
  }

  /** {@code start} with the smallest number that makes a new name; taken from now on. */
  private String name(String start) {
    int number = 1;
    while (!taken.add(start + "_" + number)) {
      number++;
    }
    return start + "_" + number;
  }
}
