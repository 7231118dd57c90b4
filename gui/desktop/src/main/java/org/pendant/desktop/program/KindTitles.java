package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import org.pendant.kit.text.Messages;
import org.pendant.project.program.NodeKind;

/** Kind titles: what kinds of nodes are called in the language of the window. */
final class KindTitles {
  private KindTitles() {}

  /** The title of a kind; moves and what cannot be added keep the one of the project. */
  static String of(NodeKind kind) {
    return switch (kind) {
      case WAYPOINT -> text("waypointKind");
      case DIRECTION -> text("directionKind");
      case UNTIL -> text("untilKind");
      case HOME -> text("homeKind");
      case WAIT -> text("waitKind");
      case SET -> text("setKind");
      case POPUP -> text("popupKind");
      case HALT -> text("haltKind");
      case COMMENT -> text("commentKind");
      case FOLDER -> text("folderKind");
      case LOOP -> text("loopKind");
      case CALL -> text("callKind");
      case ASSIGNMENT -> text("assignmentKind");
      case OPERATOR_INPUT -> text("operatorInputKind");
      case IF -> text("ifKind");
      case ELSE_IF -> text("elseIfKind");
      case ELSE -> text("elseKind");
      case SWITCH -> text("switchKind");
      case CASE -> text("caseKind");
      case DEFAULT_CASE -> text("defaultCaseKind");
      case SCRIPT_LINE -> text("scriptLineKind");
      case SCRIPT_FILE -> text("scriptFileKind");
      case TIMER -> text("timerKind");
      case PALLETIZING -> text("palletizingKind");
      case APPROACH -> text("approachKind");
      case PATTERN_POINT -> text("patternPointKind");
      case EXIT -> text("exitKind");
      case PART_BEFORE -> text("partBeforeKind");
      case PART_AFTER -> text("partAfterKind");
      case PART_SEQUENCE -> text("partSequenceKind");
      case STACK -> text("stackKind");
      case DESTACK -> text("destackKind");
      case FORCE -> text("forceKind");
      case SCREWDRIVING -> text("screwdrivingKind");
      case CONVEYOR_TRACKING -> text("conveyorTrackingKind");
      case INITIAL_VALUES -> text("initialValuesKind");
      case BEFORE_START -> text("beforeStartKind");
      case THREAD -> text("threadKind");
      case EVENT -> text("eventKind");
      case SUB_PROGRAM -> text("subProgramKind");
      case MOVE_JOINT, MOVE_LINEAR, MOVE_PROCESS, CIRCLE_MOVE, MAIN_PROGRAM, CONTRIBUTED, UNKNOWN ->
          Messages.shown(kind.title());
    };
  }
}
