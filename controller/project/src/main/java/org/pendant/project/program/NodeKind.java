package org.pendant.project.program;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.project.program.TemplateStep.PartKind;
import org.pendant.project.program.TemplateStep.PatternRole;

/** Node kinds as people choose them from a palette and read them on a screen. */
public enum NodeKind {
  MOVE_JOINT(Group.BASIC, "MoveJ"),
  MOVE_LINEAR(Group.BASIC, "MoveL"),
  MOVE_PROCESS(Group.BASIC, "MoveP"),
  WAYPOINT(Group.BASIC, "Waypoint"),
  DIRECTION(Group.BASIC, "Direction"),
  UNTIL(Group.BASIC, "Until"),
  CIRCLE_MOVE(Group.BASIC, "CircleMove"),
  HOME(Group.BASIC, "Home"),
  WAIT(Group.BASIC, "Wait"),
  SET(Group.BASIC, "Set"),
  POPUP(Group.BASIC, "Popup"),
  HALT(Group.BASIC, "Halt"),
  COMMENT(Group.BASIC, "Comment"),
  FOLDER(Group.BASIC, "Folder"),
  LOOP(Group.ADVANCED, "Loop"),
  CALL(Group.ADVANCED, "Call"),
  ASSIGNMENT(Group.ADVANCED, "Assignment"),
  OPERATOR_INPUT(Group.ADVANCED, "Operator input"),
  IF(Group.ADVANCED, "If"),
  ELSE_IF(Group.ADVANCED, "ElseIf"),
  ELSE(Group.ADVANCED, "Else"),
  SWITCH(Group.ADVANCED, "Switch"),
  CASE(Group.ADVANCED, "Case"),
  DEFAULT_CASE(Group.ADVANCED, "Default"),
  SCRIPT_LINE(Group.ADVANCED, "Script line"),
  SCRIPT_FILE(Group.ADVANCED, "Script file"),
  TIMER(Group.ADVANCED, "Timer"),
  PALLETIZING(Group.TEMPLATE, "Palletizing"),
  APPROACH(Group.TEMPLATE, "Approach"),
  PATTERN_POINT(Group.TEMPLATE, "Pattern point"),
  EXIT(Group.TEMPLATE, "Exit"),
  PART_BEFORE(Group.TEMPLATE, "Before start part"),
  PART_AFTER(Group.TEMPLATE, "After end part"),
  PART_SEQUENCE(Group.TEMPLATE, "Sequence part"),
  STACK(Group.TEMPLATE, "Seek: stack"),
  DESTACK(Group.TEMPLATE, "Seek: destack"),
  FORCE(Group.TEMPLATE, "Force"),
  SCREWDRIVING(Group.TEMPLATE, "Screwdriving"),
  CONVEYOR_TRACKING(Group.TEMPLATE, "Conveyor tracking"),
  INITIAL_VALUES(Group.SECTION, "Initial values"),
  BEFORE_START(Group.SECTION, "Before start"),
  THREAD(Group.SECTION, "Thread"),
  EVENT(Group.SECTION, "Event"),
  SUB_PROGRAM(Group.SECTION, "Sub program"),
  MAIN_PROGRAM(Group.GIVEN, "Main program"),
  CONTRIBUTED(Group.GIVEN, "Contributed"),
  UNKNOWN(Group.GIVEN, "Unknown");

  /** Where a kind is found on a palette. */
  public enum Group {
    BASIC,
    ADVANCED,
    TEMPLATE,
    /** Stands at the top of a program. */
    SECTION,
    /** Is there already, or comes from a file; cannot be added. */
    GIVEN
  }

  private final Group group;
  private final String title;

  NodeKind(Group group, String title) {
    this.group = group;
    this.title = title;
  }

  /** Where it is found. */
  public Group group() {
    return group;
  }

  /** What people call it. */
  public String title() {
    return title;
  }

  /** The kinds of a group, in the order in which they are shown. */
  public static List<NodeKind> in(Group group) {
    return Arrays.stream(values()).filter(each -> each.group == group).toList();
  }

  /** The kind that has a title. */
  public static Optional<NodeKind> titled(String title) {
    return Arrays.stream(values()).filter(each -> each.title.equals(title)).findAny();
  }

  /** The kind of a step. */
  public static NodeKind of(Step step) {
    return switch (step) {
      case Section section -> section(section);
      case MotionStep motion -> motion(motion);
      case ActionStep action -> action(action);
      case FlowStep flow -> flow(flow);
      case TemplateStep template -> template(template);
      case ForeignStep.Contributed _ -> CONTRIBUTED;
      case ForeignStep.Unknown _ -> UNKNOWN;
    };
  }

  private static NodeKind section(Section section) {
    return switch (section) {
      case Section.InitialValues _ -> INITIAL_VALUES;
      case Section.BeforeStart _ -> BEFORE_START;
      case Section.MainProgram _ -> MAIN_PROGRAM;
      case Section.ThreadSection _ -> THREAD;
      case Section.Event _ -> EVENT;
      case Section.SubProgram _ -> SUB_PROGRAM;
    };
  }

  private static NodeKind motion(MotionStep motion) {
    return switch (motion) {
      case MotionStep.Move move ->
          switch (move.kind()) {
            case JOINT -> MOVE_JOINT;
            case LINEAR -> MOVE_LINEAR;
            case PROCESS -> MOVE_PROCESS;
          };
      case MotionStep.Waypoint _ -> WAYPOINT;
      case MotionStep.CircleMove _ -> CIRCLE_MOVE;
      case MotionStep.Direction _ -> DIRECTION;
      case MotionStep.Until _ -> UNTIL;
      case MotionStep.Home _ -> HOME;
    };
  }

  private static NodeKind action(ActionStep action) {
    return switch (action) {
      case ActionStep.Wait _ -> WAIT;
      case ActionStep.SetAction _ -> SET;
      case ActionStep.Popup _ -> POPUP;
      case ActionStep.Halt _ -> HALT;
      case ActionStep.Comment _ -> COMMENT;
      case ActionStep.Folder _ -> FOLDER;
      case ActionStep.Assignment _ -> ASSIGNMENT;
      case ActionStep.OperatorInput _ -> OPERATOR_INPUT;
      case ActionStep.Call _ -> CALL;
      case ActionStep.ScriptLine _ -> SCRIPT_LINE;
      case ActionStep.ScriptFile _ -> SCRIPT_FILE;
      case ActionStep.Timer _ -> TIMER;
    };
  }

  private static NodeKind flow(FlowStep flow) {
    return switch (flow) {
      case FlowStep.If _ -> IF;
      case FlowStep.ElseIf _ -> ELSE_IF;
      case FlowStep.Else _ -> ELSE;
      case FlowStep.Loop _ -> LOOP;
      case FlowStep.Switch _ -> SWITCH;
      case FlowStep.Case _ -> CASE;
      case FlowStep.DefaultCase _ -> DEFAULT_CASE;
    };
  }

  private static NodeKind template(TemplateStep template) {
    return switch (template) {
      case TemplateStep.Palletizing _ -> PALLETIZING;
      case TemplateStep.PatternPoint point -> point(point.role());
      case TemplateStep.Part part -> part(part.kind());
      case TemplateStep.Seek seek -> seek.destack() ? DESTACK : STACK;
      case TemplateStep.Force _ -> FORCE;
      case TemplateStep.Screwdriving _ -> SCREWDRIVING;
      case TemplateStep.ConveyorTracking _ -> CONVEYOR_TRACKING;
    };
  }

  private static NodeKind point(PatternRole role) {
    return switch (role) {
      case APPROACH -> APPROACH;
      case POINT -> PATTERN_POINT;
      case EXIT -> EXIT;
    };
  }

  private static NodeKind part(PartKind kind) {
    return switch (kind) {
      case BEFORE_START -> PART_BEFORE;
      case AFTER_END -> PART_AFTER;
      case SEQUENCE -> PART_SEQUENCE;
    };
  }
}
