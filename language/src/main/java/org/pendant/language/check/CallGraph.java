package org.pendant.language.check;

import static org.pendant.language.check.CheckTexts.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Statement.Definition;

/** Call graph: which function calls which, and what follows from it for robot time. */
final class CallGraph {

  /** One function, thread or main level. */
  static final class Node {
    private final String name;
    private final List<Node> callers = new ArrayList<>();
    private final List<Node> callees = new ArrayList<>();
    private final List<Refusal> refusals = new ArrayList<>();
    private boolean waits;

    Node(String name) {
      this.name = name;
    }

    /** That of its definition; empty for a main level without one. */
    String name() {
      return name;
    }

    /** Those that it calls so far. */
    List<Node> callees() {
      return callees;
    }

    /** What no secondary program may do so far. */
    List<Refusal> refusals() {
      return refusals;
    }

    boolean isWaiting() {
      return waits;
    }

    /** Notes that this one may let robot time pass, or end the program. */
    void waits() {
      waits = true;
    }

    void calls(Node callee) {
      callees.add(callee);
      callee.callers.add(this);
    }

    /** Notes something that no secondary program may do. */
    void refuseInSecondary(SourceRange range, String key) {
      refuseInSecondary(range, key, "");
    }

    /** Notes a call that no secondary program may do. */
    void refuseInSecondary(SourceRange range, String key, String function) {
      refusals.add(new Refusal(range, key, function));
    }
  }

  /**
   * Something that no secondary program may do.
   *
   * @param key of the text that says so, which is read where it is said
   * @param function what is called; empty if it is no call
   */
  record Refusal(SourceRange range, String key, String function) {}

  /** A loop without end or wait of its own; what it calls may still wait. */
  record EndlessLoop(SourceRange range, List<Node> callees) {}

  private final IdentityHashMap<Definition, Node> nodes = new IdentityHashMap<>();
  private final List<EndlessLoop> loops = new ArrayList<>();

  Node node(Definition definition) {
    return nodes.computeIfAbsent(definition, _ -> new Node(definition.name()));
  }

  void endlessLoop(SourceRange range, List<Node> callees) {
    loops.add(new EndlessLoop(range, callees));
  }

  /** Those noted so far. */
  List<EndlessLoop> endlessLoops() {
    return loops;
  }

  void reportEndlessLoops(Diagnostics findings) {
    spreadWaits();
    for (EndlessLoop loop : loops) {
      if (loop.callees().stream().noneMatch(callee -> callee.waits)) {
        findings.warning("endless-loop", loop.range(), text("endlessLoop"));
      }
    }
  }

  /** Reports everything that the secondary program {@code name} reaches but may not do. */
  void reportSecondary(Node secondary, String name, Diagnostics findings) {
    Set<Node> reached = new HashSet<>();
    Deque<Node> open = new ArrayDeque<>();
    open.add(secondary);
    reached.add(secondary);
    while (!open.isEmpty()) {
      Node node = open.remove();
      for (Refusal refusal : node.refusals) {
        findings.error(
            "physical-time", refusal.range(), text(refusal.key(), name, refusal.function()));
      }
      for (Node callee : node.callees) {
        if (reached.add(callee)) {
          open.add(callee);
        }
      }
    }
  }

  private void spreadWaits() {
    Deque<Node> open = new ArrayDeque<>();
    for (Node node : nodes.values()) {
      if (node.waits) {
        open.add(node);
      }
    }
    while (!open.isEmpty()) {
      for (Node caller : open.remove().callers) {
        if (!caller.waits) {
          caller.waits = true;
          open.add(caller);
        }
      }
    }
  }
}
