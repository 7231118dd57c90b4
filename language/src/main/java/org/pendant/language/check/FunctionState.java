package org.pendant.language.check;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.pendant.language.source.SourceRange;

/**
 * Function state: one function while it is checked: its names, its variables so far, and its open
 * loops.
 */
final class FunctionState {
  private final FunctionScope scope;
  private final CallGraph.Node node;
  private final Flow flow = new Flow();
  private final Deque<Loop> loops = new ArrayDeque<>();

  /** An open loop and what its body has shown so far. */
  private static final class Loop {
    private final boolean conditionAlwaysTrue;
    private final List<CallGraph.Node> callees = new ArrayList<>();
    private boolean broken;
    private boolean left;
    private boolean waits;

    Loop(boolean conditionAlwaysTrue) {
      this.conditionAlwaysTrue = conditionAlwaysTrue;
    }
  }

  FunctionState(FunctionScope scope, CallGraph.Node node) {
    this.scope = scope;
    this.node = node;
  }

  FunctionScope scope() {
    return scope;
  }

  CallGraph.Node node() {
    return node;
  }

  Flow flow() {
    return flow;
  }

  boolean insideLoop() {
    return !loops.isEmpty();
  }

  void waits() {
    node.waits();
    if (insideLoop()) {
      loops.peek().waits = true;
    }
  }

  void calls(CallGraph.Node callee) {
    node.calls(callee);
    if (insideLoop()) {
      loops.peek().callees.add(callee);
    }
  }

  void breaks() {
    if (insideLoop()) {
      loops.peek().broken = true;
    }
  }

  /** A {@code return} or {@code halt}: it ends every open loop. */
  void leaves() {
    if (insideLoop()) {
      loops.peek().left = true;
    }
  }

  void openLoop(boolean conditionAlwaysTrue) {
    loops.push(new Loop(conditionAlwaysTrue));
  }

  void closeLoop(SourceRange head, CallGraph graph) {
    Loop loop = loops.pop();
    boolean endless = loop.conditionAlwaysTrue && !loop.broken && !loop.left && !loop.waits;
    if (endless) {
      graph.endlessLoop(head, loop.callees);
    }
    if (insideLoop()) {
      Loop outer = loops.peek();
      outer.left |= loop.left;
      // A loop around an endless one is not reported a second time.
      outer.waits |= loop.waits || endless;
      outer.callees.addAll(loop.callees);
    }
  }
}
