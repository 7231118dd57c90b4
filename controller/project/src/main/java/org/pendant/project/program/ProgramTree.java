package org.pendant.project.program;

import static org.pendant.project.program.ProgramTreeTexts.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * Program tree; immutable. Each change answers another tree, which shares what is as before; so a
 * history of trees costs little.
 *
 * @param installation name of the installation file that it was made for; empty for none
 * @param waypoints places that were taught, by name, in the order in which they are written
 * @param sections the nodes at the top, whose steps are {@link Section}s; one is the {@link
 *     Section.MainProgram}
 * @param nextKey larger than the key of every node
 */
public record ProgramTree(
    String installation,
    Map<String, WaypointPosition> waypoints,
    List<ProgramNode> sections,
    long nextKey) {
  /** Stands for the program itself where a parent is asked for. */
  public static final long ROOT = 0;

  /** How many levels nodes may go below a section. */
  public static final int DEEPEST = 200;

  /** What is made of a tree, such as one that starts somewhere else, may be deeper. */
  private static final int DEEPEST_MADE = 2 * DEEPEST;

  /**
   * Copies map and list. No tree is so deep that those who walk it by recursion come to the end of
   * a stack.
   *
   * @throws IllegalArgumentException if nodes go more than twice {@link #DEEPEST} levels below a
   *     section
   */
  public ProgramTree {
    waypoints = Collections.unmodifiableMap(new LinkedHashMap<>(waypoints));
    sections = List.copyOf(sections);
    if (levels(sections, DEEPEST_MADE) > DEEPEST_MADE) {
      throw new IllegalArgumentException(tooDeep());
    }
  }

  private static String tooDeep() {
    return text("tooDeep", DEEPEST);
  }

  /** How many levels there are below some nodes; one more than {@code most} if there are more. */
  private static int levels(List<ProgramNode> nodes, int most) {
    Deque<Iterator<ProgramNode>> open = new ArrayDeque<>();
    open.push(nodes.iterator());
    int levels = 0;
    while (!open.isEmpty() && levels <= most) {
      if (!open.getFirst().hasNext()) {
        open.pop();
        continue;
      }
      List<ProgramNode> below = open.getFirst().next().children();
      if (!below.isEmpty()) {
        levels = Math.max(levels, open.size());
        open.push(below.iterator());
      }
    }
    return levels;
  }

  /**
   * Why nodes cannot be put below another one, as far as depth is concerned.
   *
   * @param parent key of that node, or {@link #ROOT}
   */
  public Optional<String> whyTooDeep(long parent, List<ProgramNode> added) {
    int level = 0;
    for (long key = parent; key != ROOT; key = parentOf(key).orElse(ROOT)) {
      level++;
    }
    return level + levels(added, DEEPEST) > DEEPEST ? Optional.of(tooDeep()) : Optional.empty();
  }

  /** A new program: a main program without nodes. */
  public static ProgramTree empty() {
    return new ProgramTree("", Map.of(), List.of(), 1)
        .insert(ROOT, 0, List.of(node(new Section.MainProgram(true))));
  }

  /** A node without children that gets its key when it is put into a tree. */
  public static ProgramNode node(Step step, ProgramNode... children) {
    return new ProgramNode(ROOT, step, false, List.of(children));
  }

  /** Hands over every node, each before its children, in the order of their line numbers. */
  public void forEach(Consumer<ProgramNode> action) {
    sections.forEach(each -> visit(each, action));
  }

  private static void visit(ProgramNode node, Consumer<ProgramNode> action) {
    action.accept(node);
    node.children().forEach(each -> visit(each, action));
  }

  /** All nodes, each before its children. Line numbers are places in this list, from 1. */
  public List<ProgramNode> nodes() {
    List<ProgramNode> all = new ArrayList<>();
    forEach(all::add);
    return all;
  }

  /** The node with a key. */
  public Optional<ProgramNode> find(long key) {
    return find(sections, key);
  }

  private static Optional<ProgramNode> find(List<ProgramNode> among, long key) {
    for (ProgramNode each : among) {
      Optional<ProgramNode> found =
          each.key() == key ? Optional.of(each) : find(each.children(), key);
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  /** The key of the node above another one; {@link #ROOT} for sections. */
  public Optional<Long> parentOf(long key) {
    return parentOf(ROOT, sections, key);
  }

  private static Optional<Long> parentOf(long parent, List<ProgramNode> among, long key) {
    for (ProgramNode each : among) {
      Optional<Long> found =
          each.key() == key ? Optional.of(parent) : parentOf(each.key(), each.children(), key);
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  /** The children of a node, or the sections for {@link #ROOT}. */
  public List<ProgramNode> childrenOf(long key) {
    return key == ROOT ? sections : find(key).map(ProgramNode::children).orElse(List.of());
  }

  /**
   * The tree with nodes put in, which all get new keys, counted from {@link #nextKey}, each before
   * its children.
   *
   * @param parent key of the node that they come below, or {@link #ROOT}
   * @param index before which of its children; the number of children for the end
   * @throws IllegalArgumentException if {@link #whyTooDeep} has a reason
   */
  public ProgramTree insert(long parent, int index, List<ProgramNode> added) {
    whyTooDeep(parent, added)
        .ifPresent(
            reason -> {
              throw new IllegalArgumentException(reason);
            });
    long[] next = {nextKey};
    List<ProgramNode> keyed = added.stream().map(each -> keyed(each, next)).toList();
    return changed(
        parent,
        children -> {
          List<ProgramNode> all = new ArrayList<>(children);
          all.addAll(index, keyed);
          return all;
        },
        next[0]);
  }

  private static ProgramNode keyed(ProgramNode node, long[] next) {
    long key = next[0]++;
    List<ProgramNode> children = node.children().stream().map(each -> keyed(each, next)).toList();
    return new ProgramNode(key, node.step(), node.suppressed(), children);
  }

  /** The tree without the nodes of these keys and what is below them. */
  public ProgramTree remove(Collection<Long> keys) {
    Set<Long> gone = Set.copyOf(keys);
    return with(without(sections, gone), nextKey);
  }

  private static List<ProgramNode> without(List<ProgramNode> nodes, Set<Long> gone) {
    return replaced(nodes, each -> gone.contains(each.key()) ? List.of() : inside(each, gone));
  }

  @SuppressWarnings("ReferenceEquality") // what is the same object has not changed
  private static List<ProgramNode> inside(ProgramNode node, Set<Long> gone) {
    List<ProgramNode> kept = without(node.children(), gone);
    return List.of(kept == node.children() ? node : node.withChildren(kept));
  }

  /** The tree with another step in a node. */
  public ProgramTree withStep(long key, Step step) {
    return withNode(key, node -> node.withStep(step));
  }

  /** The tree with a node, not its key, changed. */
  public ProgramTree withNode(long key, UnaryOperator<ProgramNode> change) {
    return with(changedNode(sections, key, change), nextKey);
  }

  @SuppressWarnings("ReferenceEquality") // what is the same object has not changed
  private static List<ProgramNode> changedNode(
      List<ProgramNode> nodes, long key, UnaryOperator<ProgramNode> change) {
    return replaced(
        nodes,
        each -> {
          if (each.key() == key) {
            return List.of(change.apply(each));
          }
          List<ProgramNode> below = changedNode(each.children(), key, change);
          return List.of(below == each.children() ? each : each.withChildren(below));
        });
  }

  private ProgramTree changed(
      long parent, UnaryOperator<List<ProgramNode>> change, long nextAfterwards) {
    return parent == ROOT
        ? with(change.apply(sections), nextAfterwards)
        : with(
            changedNode(sections, parent, node -> node.withChildren(change.apply(node.children()))),
            nextAfterwards);
  }

  /** The tree with a place taught, under a new name or anew. */
  public ProgramTree withWaypoint(String name, WaypointPosition position) {
    Map<String, WaypointPosition> all = new LinkedHashMap<>(waypoints);
    all.put(name, position);
    return withWaypoints(all);
  }

  /** The tree with other places. */
  public ProgramTree withWaypoints(Map<String, WaypointPosition> others) {
    return new ProgramTree(installation, others, sections, nextKey);
  }

  /** The tree for another installation. */
  public ProgramTree withInstallation(String name) {
    return new ProgramTree(name, waypoints, sections, nextKey);
  }

  private ProgramTree with(List<ProgramNode> others, long nextAfterwards) {
    return new ProgramTree(installation, waypoints, others, nextAfterwards);
  }

  /** The same tree with keys counted from 1: equal for programs that are alike. */
  public ProgramTree renumbered() {
    return new ProgramTree(installation, waypoints, List.of(), 1).insert(ROOT, 0, sections);
  }

  /** Each node replaced by others; the same list where each stays as it is. */
  @SuppressWarnings("ReferenceEquality") // what is the same object has not changed
  private static List<ProgramNode> replaced(
      List<ProgramNode> nodes, Function<ProgramNode, List<ProgramNode>> by) {
    List<ProgramNode> result = new ArrayList<>(nodes.size());
    boolean same = true;
    for (ProgramNode each : nodes) {
      List<ProgramNode> others = by.apply(each);
      same &= others.size() == 1 && others.getFirst() == each;
      result.addAll(others);
    }
    return same ? nodes : result;
  }
}
