package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.pendant.project.program.Placement;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;

/** Tree edits: what people do to whole nodes of a tree. Moved nodes keep their keys. */
final class TreeEdits {
  private TreeEdits() {}

  /** The chosen nodes without those below another chosen one, in the order of the tree. */
  static List<ProgramNode> tops(ProgramTree tree, Collection<Long> keys) {
    List<ProgramNode> found = new ArrayList<>();
    collect(tree.sections(), new HashSet<>(keys), found);
    return found;
  }

  private static void collect(List<ProgramNode> among, Set<Long> keys, List<ProgramNode> found) {
    for (ProgramNode each : among) {
      if (keys.contains(each.key())) {
        found.add(each);
      } else {
        collect(each.children(), keys, found);
      }
    }
  }

  /** The keys of nodes. */
  static List<Long> keys(List<ProgramNode> nodes) {
    return nodes.stream().map(ProgramNode::key).toList();
  }

  /** Whether a node can be taken away: every program has its main program. */
  static boolean removable(ProgramNode node) {
    return !(node.step() instanceof Section.MainProgram);
  }

  /** The tree without the chosen nodes. */
  static ProgramTree delete(ProgramTree tree, Collection<Long> keys) {
    return tree.remove(keys(tops(tree, keys).stream().filter(TreeEdits::removable).toList()));
  }

  /** The key of the node to select when these are gone: the next one beside them, or above. */
  static OptionalLong afterDelete(ProgramTree tree, Collection<Long> keys) {
    List<ProgramNode> gone = tops(tree, keys).stream().filter(TreeEdits::removable).toList();
    if (gone.isEmpty()) {
      return OptionalLong.empty();
    }
    long parent = tree.parentOf(gone.getLast().key()).orElse(ProgramTree.ROOT);
    List<ProgramNode> beside = tree.childrenOf(parent);
    int last = index(beside, gone.getLast().key());
    Set<Long> goneKeys = new HashSet<>(keys(gone));
    for (int i = last + 1; i < beside.size(); i++) {
      if (!goneKeys.contains(beside.get(i).key())) {
        return OptionalLong.of(beside.get(i).key());
      }
    }
    for (int i = last - 1; i >= 0; i--) {
      if (!goneKeys.contains(beside.get(i).key())) {
        return OptionalLong.of(beside.get(i).key());
      }
    }
    return parent == ProgramTree.ROOT ? OptionalLong.empty() : OptionalLong.of(parent);
  }

  /** The tree with the chosen nodes suppressed, or not any more if all of them are. */
  static ProgramTree toggleSuppressed(ProgramTree tree, Collection<Long> keys) {
    List<ProgramNode> chosen = tops(tree, keys);
    boolean wanted = !chosen.stream().allMatch(ProgramNode::suppressed);
    ProgramTree next = tree;
    for (ProgramNode each : chosen) {
      if (removable(each)) {
        next = next.withNode(each.key(), node -> node.withSuppressed(wanted));
      }
    }
    return next;
  }

  /** The tree with copies of the chosen nodes behind the last of them. */
  static ProgramTree duplicate(ProgramTree tree, Collection<Long> keys) {
    List<ProgramNode> chosen = tops(tree, keys).stream().filter(TreeEdits::removable).toList();
    if (chosen.isEmpty()) {
      return tree;
    }
    Spot behind = behind(tree, chosen.getLast().key());
    return tree.insert(behind.parent(), behind.index(), chosen);
  }

  /** The place behind a node. */
  static Spot behind(ProgramTree tree, long key) {
    long parent = tree.parentOf(key).orElse(ProgramTree.ROOT);
    return new Spot(parent, index(tree.childrenOf(parent), key) + 1);
  }

  /** Which of some nodes has a key; -1 if none. */
  static int index(List<ProgramNode> nodes, long key) {
    for (int i = 0; i < nodes.size(); i++) {
      if (nodes.get(i).key() == key) {
        return i;
      }
    }
    return -1;
  }

  /**
   * Why nodes cannot be put somewhere; empty if they can.
   *
   * @param moved whether they are nodes of the tree, which leave their places
   */
  static Optional<String> whyNot(
      ProgramTree tree, List<ProgramNode> nodes, Spot spot, boolean moved) {
    ProgramTree rest = moved ? tree.remove(keys(nodes)) : tree;
    if (spot.parent() != ProgramTree.ROOT && rest.find(spot.parent()).isEmpty()) {
      return Optional.of(text("aNodeCannotGoBelowItself"));
    }
    return nodes.stream()
        .flatMap(each -> Placement.whyNot(rest, spot.parent(), each.step()).stream())
        .findFirst()
        .or(() -> rest.whyTooDeep(spot.parent(), nodes));
  }

  /** The tree with nodes of it at another place, in their order. */
  static ProgramTree move(ProgramTree tree, List<ProgramNode> nodes, Spot spot) {
    Set<Long> moved = new HashSet<>(keys(nodes));
    List<ProgramNode> there = tree.childrenOf(spot.parent());
    int before =
        (int) there.subList(0, spot.index()).stream().filter(e -> moved.contains(e.key())).count();
    UnaryOperator<List<ProgramNode>> put =
        children -> {
          List<ProgramNode> all = new ArrayList<>(children);
          all.addAll(spot.index() - before, nodes);
          return all;
        };
    ProgramTree rest = tree.remove(moved);
    if (spot.parent() == ProgramTree.ROOT) {
      return new ProgramTree(
          rest.installation(), rest.waypoints(), put.apply(rest.sections()), rest.nextKey());
    }
    return rest.withNode(spot.parent(), node -> node.withChildren(put.apply(node.children())));
  }

  /**
   * The place one line up or down for the chosen nodes: past the node beside them, or at the edge
   * out of the node above. Empty where there is none.
   */
  static Optional<Spot> shifted(ProgramTree tree, List<ProgramNode> chosen, boolean down) {
    if (chosen.isEmpty()) {
      return Optional.empty();
    }
    ProgramNode edge = down ? chosen.getLast() : chosen.getFirst();
    long parent = tree.parentOf(edge.key()).orElse(ProgramTree.ROOT);
    List<ProgramNode> beside = tree.childrenOf(parent);
    int index = index(beside, edge.key());
    Optional<Spot> next = Optional.empty();
    if (down ? index + 1 < beside.size() : index > 0) {
      next = Optional.of(new Spot(parent, down ? index + 2 : index - 1));
    } else if (parent != ProgramTree.ROOT) {
      Spot behind = behind(tree, parent);
      next = Optional.of(new Spot(behind.parent(), down ? behind.index() : behind.index() - 1));
    }
    return next.filter(spot -> whyNot(tree, chosen, spot, true).isEmpty());
  }
}
