package org.pendant.project.program;

import static org.pendant.project.program.ProgramTree.node;

import java.util.ArrayList;
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
 * Node factory: makes nodes as a palette adds them: with the values that a robot's own screen
 * begins with, and with the nodes below them that they cannot do without. Names are such that the
 * tree does not have yet.
 */
public final class NewNodes {
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
                  NodeFields.HOME_SPEED.initialValue(),
                  NodeFields.HOME_ACCELERATION.initialValue(),
                  NodeFields.HOME_TIME.initial()));
      case WAIT -> node(new ActionStep.Wait(new WaitFor.Time(NodeFields.WAIT_TIME.initialValue())));
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
                  new ToolChoice.Active(),
                  true,
                  NodeFields.screwValue(true).initialValue(),
                  false,
                  "",
                  "",
                  NodeFields.SCREW_TIMEOUT.initialValue()));
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
    return new Move(
        kind,
        NodeFields.speed(kind).initialValue(),
        NodeFields.acceleration(kind).initialValue(),
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
            WaypointPosition.BASE,
            NodeFields.DIRECTION_X.initialValue(),
            NodeFields.DIRECTION_Y.initialValue(),
            NodeFields.DIRECTION_Z.initialValue(),
            NodeFields.DIRECTION_SPEED.initial(),
            NodeFields.DIRECTION_ACCELERATION.initial()),
        until());
  }

  private static ProgramNode until() {
    return node(new Until(new UntilRule.Distance(NodeFields.UNTIL_DISTANCE.initialValue())));
  }

  private ProgramNode palletizing() {
    return node(
        new TemplateStep.Palletizing(
            name("Pallet"),
            new Pattern.Line(
                name("StartItem"), name("EndItem"), (int) NodeFields.LINE_PLACES.initialValue()),
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
            NodeFields.speed(MoveKind.LINEAR).initialValue(),
            NodeFields.acceleration(MoveKind.LINEAR).initialValue(),
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
            List.of(
                NodeFields.SEEK_X.initialValue(),
                NodeFields.SEEK_Y.initialValue(),
                NodeFields.SEEK_Z.initialValue()),
            NodeFields.SEEK_LIMIT.initialValue(),
            NodeFields.ITEM_HEIGHT.initialValue(),
            "",
            NodeFields.SEEK_SPEED.initialValue(),
            NodeFields.SEEK_ACCELERATION.initialValue()),
        part(PartKind.SEQUENCE));
  }

  private static ProgramNode force() {
    List<Boolean> compliant = List.of(false, false, true, false, false, false);
    List<Double> wrench = new ArrayList<>();
    List<Double> limits = new ArrayList<>();
    for (int i = 0; i < compliant.size(); i++) {
      wrench.add(NodeFields.wrench(i).initialValue());
      limits.add(NodeFields.forceLimit(i, compliant.get(i)).initialValue());
    }
    return node(
        new TemplateStep.Force(ForceKind.SIMPLE, WaypointPosition.TOOL, compliant, wrench, limits));
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
