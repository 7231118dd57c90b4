package org.pendant.desktop.program;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.NewNodes;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.Placement;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Step;

/**
 * Spots for new nodes: where nodes are put that the user adds without saying where: into the
 * selected node, or after it, or after the first node above it where they may stand.
 */
final class NewSpots {
  private NewSpots() {}

  /**
   * Nodes and where they go.
   *
   * @param nodes with a move around them where they need one
   */
  record Addition(List<ProgramNode> nodes, Spot spot) {
    Addition {
      nodes = List.copyOf(nodes);
    }
  }

  /**
   * A new node of a kind and where it goes; empty if there is no place for it near the selected
   * node.
   *
   * @param selected key of a node; empty for the main program
   */
  static Optional<Addition> of(ProgramTree tree, OptionalLong selected, NodeKind kind) {
    ProgramNode made = NewNodes.of(kind, tree);
    Optional<Addition> there =
        spot(tree, selected, made.step(), true).map(spot -> new Addition(List.of(made), spot));
    return there.or(
        () ->
            inMove(tree, kind, made)
                .flatMap(
                    move ->
                        spot(tree, selected, move.step(), true)
                            .map(spot -> new Addition(List.of(move), spot))));
  }

  /** A move around a node that stands only in moves. */
  private static Optional<ProgramNode> inMove(ProgramTree tree, NodeKind kind, ProgramNode made) {
    return switch (kind) {
      case WAYPOINT ->
          Optional.of(NewNodes.of(NodeKind.MOVE_JOINT, tree).withChildren(List.of(made)));
      case DIRECTION ->
          Optional.of(NewNodes.of(NodeKind.MOVE_LINEAR, tree).withChildren(List.of(made)));
      case CIRCLE_MOVE ->
          Optional.of(NewNodes.of(NodeKind.MOVE_PROCESS, tree).withChildren(List.of(made)));
      default -> Optional.empty();
    };
  }

  /**
   * Where a node goes.
   *
   * @param into whether it may go into the selected node itself
   */
  static Optional<Spot> spot(ProgramTree tree, OptionalLong selected, Step step, boolean into) {
    if (step instanceof Section section) {
      return Placement.whyNot(tree, ProgramTree.ROOT, step).isPresent()
          ? Optional.empty()
          : Optional.of(new Spot(ProgramTree.ROOT, place(tree, section)));
    }
    Optional<ProgramNode> start =
        selected.isPresent() ? tree.find(selected.getAsLong()) : Optional.empty();
    ProgramNode at = start.or(() -> main(tree)).orElse(tree.sections().getFirst());
    if (step instanceof FlowStep.ElseIf || step instanceof FlowStep.Else) {
      return behindIf(tree, at, step instanceof FlowStep.Else);
    }
    if (into && Placement.allows(at.step(), step)) {
      return Optional.of(new Spot(at.key(), at.children().size()));
    }
    long below = at.key();
    while (true) {
      Spot behind = TreeEdits.behind(tree, below);
      if (behind.parent() == ProgramTree.ROOT) {
        return Optional.empty();
      }
      if (Placement.whyNot(tree, behind.parent(), step).isEmpty()) {
        return Optional.of(behindBranches(tree, behind));
      }
      below = behind.parent();
    }
  }

  private static Optional<ProgramNode> main(ProgramTree tree) {
    return tree.sections().stream()
        .filter(each -> each.step() instanceof Section.MainProgram)
        .findFirst();
  }

  /** Values first, then what runs before the start, then the program, then what stands beside. */
  private static int place(ProgramTree tree, Section section) {
    int rank = rank(section);
    int index = 0;
    while (index < tree.sections().size() && rank(tree.sections().get(index).step()) <= rank) {
      index++;
    }
    return index;
  }

  private static int rank(Step section) {
    return switch (NodeKind.of(section)) {
      case INITIAL_VALUES -> 0;
      case BEFORE_START -> 1;
      case MAIN_PROGRAM -> 2;
      default -> 3;
    };
  }

  /** Behind the If that {@code at} belongs to; an Else behind all its branches. */
  private static Optional<Spot> behindIf(ProgramTree tree, ProgramNode at, boolean last) {
    ProgramNode each = at;
    while (!isBranch(each.step())) {
      Optional<ProgramNode> above = tree.parentOf(each.key()).flatMap(tree::find);
      if (above.isEmpty()) {
        return Optional.empty();
      }
      each = above.get();
    }
    Spot behind = TreeEdits.behind(tree, each.key());
    List<ProgramNode> beside = tree.childrenOf(behind.parent());
    if (each.step() instanceof FlowStep.Else) {
      return last ? Optional.empty() : Optional.of(new Spot(behind.parent(), behind.index() - 1));
    }
    int index = behind.index();
    while (last && index < beside.size() && beside.get(index).step() instanceof FlowStep.ElseIf) {
      index++;
    }
    boolean taken =
        last && index < beside.size() && beside.get(index).step() instanceof FlowStep.Else;
    return taken ? Optional.empty() : Optional.of(new Spot(behind.parent(), index));
  }

  private static boolean isBranch(Step step) {
    return step instanceof FlowStep.If
        || step instanceof FlowStep.ElseIf
        || step instanceof FlowStep.Else;
  }

  /** Nothing goes between an If and its other branches. */
  private static Spot behindBranches(ProgramTree tree, Spot spot) {
    List<ProgramNode> beside = tree.childrenOf(spot.parent());
    int index = spot.index();
    while (index < beside.size()
        && (beside.get(index).step() instanceof FlowStep.ElseIf
            || beside.get(index).step() instanceof FlowStep.Else)) {
      index++;
    }
    return new Spot(spot.parent(), index);
  }
}
