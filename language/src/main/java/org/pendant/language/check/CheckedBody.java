package org.pendant.language.check;

import java.util.List;
import org.pendant.language.check.CallGraph.EndlessLoop;
import org.pendant.language.check.CallGraph.Refusal;
import org.pendant.language.source.Diagnostic;

/**
 * Checked body: what the check of one definition's body has found, where that depends on nothing
 * but what the check memory compares.
 *
 * @param start where the definition stood
 * @param callees the functions that it calls, in their order
 * @param loops those of its loops that have no end
 */
record CheckedBody(
    int start,
    List<Diagnostic> findings,
    List<Diagnostic> unassigned,
    boolean waits,
    List<String> callees,
    List<Refusal> refusals,
    List<Loop> loops) {

  /** A loop without an end, and the functions that it calls. */
  record Loop(Refusal head, List<String> callees) {}

  static Loop loop(EndlessLoop loop) {
    return new Loop(
        new Refusal(loop.range(), "", ""),
        loop.callees().stream().map(CallGraph.Node::name).toList());
  }
}
