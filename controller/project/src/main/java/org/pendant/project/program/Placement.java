package org.pendant.project.program;

import static org.pendant.project.program.ProgramTreeTexts.text;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;

/**
 * Placement rules: which nodes may stand below which. The order among the children is not its
 * concern.
 */
public final class Placement {
  private Placement() {}

  /** Nodes that stand at the same places. */
  private enum Sort {
    /** Whatever a program is made of. */
    STEP("placesOfSteps"),
    SECTION("placeOfSections"),
    MOVE("placesOfMoves"),
    WAYPOINT("placesOfWaypoints"),
    CIRCLE("placeOfCircles"),
    DIRECTION("placeOfDirections"),
    UNTIL("placesOfUntil"),
    CASE("placeOfCases"),
    POINT("placesOfPatternPoints"),
    PART("placesOfParts");

    private final String key;

    Sort(String key) {
      this.key = key;
    }

    /** Below what they may stand. */
    String places() {
      return text(key);
    }
  }

  private static final Set<Sort> NOTHING = EnumSet.noneOf(Sort.class);
  private static final Set<Sort> STEPS = EnumSet.of(Sort.STEP, Sort.MOVE);
  private static final Set<Sort> OF_MOVE = EnumSet.of(Sort.STEP, Sort.WAYPOINT, Sort.DIRECTION);
  private static final Set<Sort> OF_PROCESS =
      EnumSet.of(Sort.STEP, Sort.WAYPOINT, Sort.DIRECTION, Sort.CIRCLE);
  private static final Set<Sort> UNTILS = EnumSet.of(Sort.UNTIL);
  private static final Set<Sort> WAYPOINTS = EnumSet.of(Sort.WAYPOINT);
  private static final Set<Sort> CASES = EnumSet.of(Sort.CASE);
  private static final Set<Sort> OF_PART = EnumSet.of(Sort.STEP, Sort.MOVE, Sort.POINT);
  private static final Set<Sort> OF_TEMPLATE =
      EnumSet.of(Sort.STEP, Sort.MOVE, Sort.POINT, Sort.PART);

  /** Whether a node may have any nodes below it. */
  public static boolean holdsOthers(Step step) {
    return !room(step).isEmpty();
  }

  /** Whether {@code child} may stand directly below {@code parent}. */
  public static boolean allows(Step parent, Step child) {
    return room(parent).contains(sort(child));
  }

  /** Why {@code child} may not stand directly below {@code parent}; empty if it may. */
  public static Optional<String> whyNot(Step parent, Step child) {
    if (allows(parent, child)) {
      return Optional.empty();
    }
    if (!holdsOthers(parent)) {
      return Optional.of(text("holdsNoNodes", title(parent)));
    }
    return Optional.of(text("wrongPlace", title(child), title(parent), sort(child).places()));
  }

  /**
   * Why a node may not be added below the node with key {@code parent}, or at the top for {@link
   * ProgramTree#ROOT}; empty if it may.
   */
  public static Optional<String> whyNot(ProgramTree tree, long parent, Step child) {
    return parent == ProgramTree.ROOT
        ? whyNotAtTop(tree, child)
        : tree.find(parent)
            .map(above -> whyNot(above.step(), child))
            .orElse(Optional.of(text("parentGone")));
  }

  private static Optional<String> whyNotAtTop(ProgramTree tree, Step child) {
    if (!(child instanceof Section section)) {
      return Optional.of(text("notAtTop", title(child), sort(child).places()));
    }
    boolean taken = tree.sections().stream().anyMatch(each -> sameKind(each.step(), section));
    return taken && onlyOnce(section)
        ? Optional.of(text("onlyOnce", title(section)))
        : Optional.empty();
  }

  private static boolean onlyOnce(Section section) {
    return switch (section) {
      case Section.InitialValues _ -> true;
      case Section.BeforeStart _ -> true;
      case Section.MainProgram _ -> true;
      case Section.ThreadSection _ -> false;
      case Section.Event _ -> false;
      case Section.SubProgram _ -> false;
    };
  }

  private static boolean sameKind(Step a, Step b) {
    return NodeKind.of(a) == NodeKind.of(b);
  }

  private static Set<Sort> room(Step parent) {
    return switch (parent) {
      case Section.InitialValues _ -> NOTHING;
      case Section _ -> STEPS;
      case MotionStep.Move move -> move.kind() == MoveKind.PROCESS ? OF_PROCESS : OF_MOVE;
      case MotionStep.Waypoint _ -> UNTILS;
      case MotionStep.CircleMove _ -> WAYPOINTS;
      case MotionStep.Direction _ -> UNTILS;
      case MotionStep.Until _ -> STEPS;
      case MotionStep.Home _ -> NOTHING;
      case ActionStep.Folder _ -> STEPS;
      case ActionStep _ -> NOTHING;
      case FlowStep.Switch _ -> CASES;
      case FlowStep _ -> STEPS;
      case TemplateStep.Palletizing _ -> OF_TEMPLATE;
      case TemplateStep.Seek _ -> OF_TEMPLATE;
      case TemplateStep.Part _ -> OF_PART;
      case TemplateStep.PatternPoint _ -> NOTHING;
      case TemplateStep _ -> STEPS;
      case ForeignStep _ -> NOTHING;
    };
  }

  private static Sort sort(Step step) {
    return switch (step) {
      case Section _ -> Sort.SECTION;
      case MotionStep.Move _ -> Sort.MOVE;
      case MotionStep.Waypoint _ -> Sort.WAYPOINT;
      case MotionStep.CircleMove _ -> Sort.CIRCLE;
      case MotionStep.Direction _ -> Sort.DIRECTION;
      case MotionStep.Until _ -> Sort.UNTIL;
      case MotionStep.Home _ -> Sort.STEP;
      case ActionStep _ -> Sort.STEP;
      case FlowStep.Case _ -> Sort.CASE;
      case FlowStep.DefaultCase _ -> Sort.CASE;
      case FlowStep _ -> Sort.STEP;
      case TemplateStep.PatternPoint _ -> Sort.POINT;
      case TemplateStep.Part _ -> Sort.PART;
      case TemplateStep _ -> Sort.STEP;
      case ForeignStep _ -> Sort.STEP;
    };
  }

  private static String title(Step step) {
    return NodeKind.of(step).title();
  }
}
