package org.pendant.project.program;

import static org.pendant.project.program.ProgramTreeTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Play from a node: starts a program at a node in its middle: the same program whose first turn
 * begins there. What stands before the node is left out of that turn, the sequence before the start
 * too; initial values, threads and events are as always.
 *
 * <p>The branches and loops around the node count as entered: their conditions are not asked, and a
 * loop continues with whole turns of its own, a counting one from 0.
 */
public final class PlayFrom {
  private PlayFrom() {}

  /** Why a program cannot start at a node; empty if it can. */
  public static Optional<String> whyNot(ProgramTree tree, long key) {
    List<ProgramNode> path = path(tree, key);
    if (path.isEmpty() || !(path.getFirst().step() instanceof Section.MainProgram)) {
      return Optional.of(text("startsInMainOnly"));
    }
    if (path.size() == 1) {
      return Optional.empty();
    }
    if (path.stream().anyMatch(ProgramNode::suppressed)) {
      return Optional.of(text("startSuppressed"));
    }
    if (path.getLast().step() instanceof FlowStep.ElseIf
        || path.getLast().step() instanceof FlowStep.Else
        || path.getLast().step() instanceof FlowStep.Case
        || path.getLast().step() instanceof FlowStep.DefaultCase) {
      return Optional.of(text("startAtBranch"));
    }
    return path.subList(1, path.size() - 1).stream()
        .filter(each -> !entered(each.step()))
        .findFirst()
        .map(each -> text("startWithinWhole"));
  }

  /** Whether a turn may begin inside of a step. */
  private static boolean entered(Step step) {
    return step instanceof MotionStep.Move
        || step instanceof ActionStep.Folder
        || (step instanceof FlowStep);
  }

  /**
   * The program that starts at a node. Nodes that stand in it twice, in the first turn and in the
   * others, have one key; it is only for generating a script.
   *
   * @throws IllegalArgumentException if {@link #whyNot} has a reason
   */
  public static ProgramTree from(ProgramTree tree, long key) {
    whyNot(tree, key)
        .ifPresent(
            reason -> {
              throw new IllegalArgumentException(reason);
            });
    List<ProgramNode> path = path(tree, key);
    if (path.size() == 1) {
      return tree;
    }
    ProgramNode main = path.getFirst();
    List<ProgramNode> turn = new ArrayList<>(rest(path, 0));
    if (((Section.MainProgram) main.step()).forever()) {
      turn.add(
          new ProgramNode(
              main.key(), new FlowStep.Loop(new LoopRule.Forever()), false, main.children()));
    }
    ProgramNode once = new ProgramNode(main.key(), new Section.MainProgram(false), false, turn);
    List<ProgramNode> sections = new ArrayList<>();
    for (ProgramNode each : tree.sections()) {
      if (each.key() == main.key()) {
        sections.add(once);
      } else if (!(each.step() instanceof Section.BeforeStart)) {
        sections.add(each);
      }
    }
    return new ProgramTree(tree.installation(), tree.waypoints(), sections, tree.nextKey());
  }

  /** What is left of the children of the node at {@code depth} of the path. */
  private static List<ProgramNode> rest(List<ProgramNode> path, int depth) {
    ProgramNode around = path.get(depth);
    ProgramNode child = path.get(depth + 1);
    List<ProgramNode> rest = new ArrayList<>();
    boolean start = depth + 2 == path.size();
    if (start) {
      rest.add(child);
    } else {
      rest.addAll(inside(child, rest(path, depth + 1)));
    }
    if (around.step() instanceof FlowStep.Switch) {
      return rest;
    }
    int next = around.children().indexOf(child) + 1;
    List<ProgramNode> after = around.children().subList(next, around.children().size());
    boolean branchesBelong = !start && branch(child.step());
    for (ProgramNode each : after) {
      branchesBelong &=
          each.step() instanceof FlowStep.ElseIf || each.step() instanceof FlowStep.Else;
      if (!branchesBelong) {
        rest.add(each);
      }
    }
    return rest;
  }

  private static boolean branch(Step step) {
    return step instanceof FlowStep.If || step instanceof FlowStep.ElseIf;
  }

  /** The rest of a node that has been entered. */
  private static List<ProgramNode> inside(ProgramNode node, List<ProgramNode> rest) {
    return switch (node.step()) {
      case MotionStep.Move move -> List.of(node.withChildren(rest));
      case ActionStep.Folder folder -> List.of(node.withChildren(rest));
      case FlowStep.Loop loop -> {
        List<ProgramNode> turns = new ArrayList<>(rest);
        turns.add(node);
        yield turns;
      }
      default -> rest;
    };
  }

  /** The nodes from the section to the one with a key, both included; empty if it is not there. */
  private static List<ProgramNode> path(ProgramTree tree, long key) {
    List<ProgramNode> path = new ArrayList<>();
    descend(tree.sections(), key, path);
    return path;
  }

  private static boolean descend(List<ProgramNode> among, long key, List<ProgramNode> path) {
    for (ProgramNode each : among) {
      path.add(each);
      if (each.key() == key || descend(each.children(), key, path)) {
        return true;
      }
      path.removeLast();
    }
    return false;
  }
}
