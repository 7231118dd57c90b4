package org.pendant.project.program;

import static org.pendant.project.program.ProgramTreeTexts.text;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.project.program.TemplateStep.PartKind;
import org.pendant.project.program.TemplateStep.PatternRole;

/** Node kinds as people choose them from a palette and read them on a screen. */
public enum NodeKind {
  MOVE_JOINT(Group.BASIC, "moveJoint"),
  MOVE_LINEAR(Group.BASIC, "moveLinear"),
  MOVE_PROCESS(Group.BASIC, "moveProcess"),
  WAYPOINT(Group.BASIC, "waypoint"),
  DIRECTION(Group.BASIC, "direction"),
  UNTIL(Group.BASIC, "until"),
  CIRCLE_MOVE(Group.BASIC, "circleMove"),
  HOME(Group.BASIC, "home"),
  WAIT(Group.BASIC, "wait"),
  SET(Group.BASIC, "set"),
  POPUP(Group.BASIC, "popup"),
  HALT(Group.BASIC, "halt"),
  COMMENT(Group.BASIC, "comment"),
  FOLDER(Group.BASIC, "folder"),
  LOOP(Group.ADVANCED, "loop"),
  CALL(Group.ADVANCED, "call"),
  ASSIGNMENT(Group.ADVANCED, "assignment"),
  OPERATOR_INPUT(Group.ADVANCED, "operatorInput"),
  IF(Group.ADVANCED, "if"),
  ELSE_IF(Group.ADVANCED, "elseIf"),
  ELSE(Group.ADVANCED, "else"),
  SWITCH(Group.ADVANCED, "switch"),
  CASE(Group.ADVANCED, "case"),
  DEFAULT_CASE(Group.ADVANCED, "default"),
  SCRIPT_LINE(Group.ADVANCED, "scriptLine"),
  SCRIPT_FILE(Group.ADVANCED, "scriptFile"),
  TIMER(Group.ADVANCED, "timer"),
  PALLETIZING(Group.TEMPLATE, "palletizing"),
  APPROACH(Group.TEMPLATE, "approach"),
  PATTERN_POINT(Group.TEMPLATE, "patternPoint"),
  EXIT(Group.TEMPLATE, "exit"),
  PART_BEFORE(Group.TEMPLATE, "beforeStartPart"),
  PART_AFTER(Group.TEMPLATE, "afterEndPart"),
  PART_SEQUENCE(Group.TEMPLATE, "sequencePart"),
  STACK(Group.TEMPLATE, "seekStack"),
  DESTACK(Group.TEMPLATE, "seekDestack"),
  FORCE(Group.TEMPLATE, "force"),
  SCREWDRIVING(Group.TEMPLATE, "screwdriving"),
  CONVEYOR_TRACKING(Group.TEMPLATE, "conveyorTracking"),
  INITIAL_VALUES(Group.SECTION, "initialValues"),
  BEFORE_START(Group.SECTION, "beforeStart"),
  THREAD(Group.SECTION, "thread"),
  EVENT(Group.SECTION, "event"),
  SUB_PROGRAM(Group.SECTION, "subProgram"),
  MAIN_PROGRAM(Group.GIVEN, "mainProgram"),
  CONTRIBUTED(Group.GIVEN, "contributed"),
  UNKNOWN(Group.GIVEN, "unknown");

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
  private final String key;

  NodeKind(Group group, String key) {
    this.group = group;
    this.key = key;
  }

  /** Where it is found. */
  public Group group() {
    return group;
  }

  /** What people call it. */
  public String title() {
    return text(key);
  }

  /** The kinds of a group, in the order in which they are shown. */
  public static List<NodeKind> in(Group group) {
    return Arrays.stream(values()).filter(each -> each.group == group).toList();
  }

  /** The kind that has a title. */
  public static Optional<NodeKind> titled(String title) {
    return Arrays.stream(values()).filter(each -> each.title().equals(title)).findAny();
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
