package org.pendant.language.check;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.language.check.CallGraph.EndlessLoop;
import org.pendant.language.check.CallGraph.Refusal;
import org.pendant.language.check.CheckMemory.Key;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Statement.Definition;

/**
 * Known bodies: those definitions in a check of which the check before has said all there is to
 * say. Left to the check are definitions with others in them, and those of which more is said than
 * follows from themselves: suggestions for names, and what is told once for a whole text.
 */
final class KnownBodies {
  private final Source source;
  private final Scopes scopes;
  private final Map<Key, CheckedBody> before;
  private final Map<Key, CheckedBody> now = new HashMap<>();

  KnownBodies(Source source, Scopes scopes, Map<Key, CheckedBody> before) {
    this.source = source;
    this.scopes = scopes;
    this.before = before;
  }

  /** What was said in this check. */
  Map<Key, CheckedBody> now() {
    return now;
  }

  /** Checks the body of a definition whose head is checked. */
  void check(Definition definition, FunctionState state, CheckRun run) {
    Optional<Key> key = key(definition, state.scope());
    Optional<CheckedBody> known = key.map(before::get);
    if (known.isPresent()) {
      now.put(key.get(), known.get());
      say(known.get(), definition.range().start(), state, run);
      return;
    }
    Progress begun = new Progress(run, state.node());
    new StatementCheck(run, state).block(definition.body());
    if (key.isPresent() && begun.isPlain(run)) {
      now.put(key.get(), begun.body(definition.range().start(), run, state.node()));
    }
  }

  /** Empty for one that has to be checked each time. */
  private Optional<Key> key(Definition definition, FunctionScope scope) {
    FunctionScope around = scope.parent().orElseThrow();
    boolean inMain = around.equals(scopes.mainScope());
    return scope.ownFunctions().isEmpty() && (inMain || around.equals(scopes.outermost()))
        ? Optional.of(new Key(source.text(definition.range()), inMain))
        : Optional.empty();
  }

  private static void say(CheckedBody body, int start, FunctionState state, CheckRun run) {
    int shift = start - body.start();
    run.findings().addAll(moved(body.findings(), shift));
    run.unassigned().addAll(moved(body.unassigned(), shift));
    CallGraph.Node node = state.node();
    if (body.waits()) {
      node.waits();
    }
    body.callees().forEach(name -> node.calls(called(name, state, run)));
    body.refusals()
        .forEach(
            each ->
                node.refuseInSecondary(moved(each.range(), shift), each.key(), each.function()));
    for (CheckedBody.Loop loop : body.loops()) {
      run.graph()
          .endlessLoop(
              moved(loop.head().range(), shift),
              loop.callees().stream().map(name -> called(name, state, run)).toList());
    }
  }

  private static CallGraph.Node called(String name, FunctionState state, CheckRun run) {
    return run.graph().node(state.scope().function(name).orElseThrow());
  }

  private static List<Diagnostic> moved(List<Diagnostic> found, int shift) {
    return shift == 0
        ? found
        : found.stream()
            .map(
                each ->
                    new Diagnostic(
                        each.code(),
                        each.severity(),
                        moved(each.range(), shift),
                        each.message(),
                        each.wireText()))
            .toList();
  }

  private static SourceRange moved(SourceRange range, int shift) {
    return new SourceRange(range.start() + shift, range.end() + shift);
  }

  /** How far a check was when a body began. */
  private static final class Progress {
    private final int findings;
    private final int unassigned;
    private final int callees;
    private final int refusals;
    private final int loops;
    private final int special;

    Progress(CheckRun run, CallGraph.Node node) {
      findings = run.findings().all().size();
      unassigned = run.unassigned().all().size();
      callees = node.callees().size();
      refusals = node.refusals().size();
      loops = run.graph().endlessLoops().size();
      special = run.special();
    }

    boolean isPlain(CheckRun run) {
      return run.special() == special;
    }

    CheckedBody body(int start, CheckRun run, CallGraph.Node node) {
      List<Refusal> refused = node.refusals();
      List<EndlessLoop> endless = run.graph().endlessLoops();
      return new CheckedBody(
          start,
          rest(run.findings().all(), findings),
          rest(run.unassigned().all(), unassigned),
          node.isWaiting(),
          rest(node.callees(), callees).stream().map(CallGraph.Node::name).toList(),
          rest(refused, refusals),
          rest(endless, loops).stream().map(CheckedBody::loop).toList());
    }

    private static <T> List<T> rest(List<T> all, int from) {
      return List.copyOf(all.subList(from, all.size()));
    }
  }
}
