package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.debug.Breakpoint;
import org.eclipse.lsp4j.debug.BreakpointNotVerifiedReason;
import org.eclipse.lsp4j.debug.DataBreakpoint;
import org.eclipse.lsp4j.debug.DataBreakpointAccessType;
import org.eclipse.lsp4j.debug.DataBreakpointInfoArguments;
import org.eclipse.lsp4j.debug.DataBreakpointInfoResponse;
import org.eclipse.lsp4j.debug.SetDataBreakpointsArguments;
import org.eclipse.lsp4j.debug.SetDataBreakpointsResponse;
import org.pendant.editors.dap.look.LiveScope;
import org.pendant.editors.dap.look.WatchedSignal;
import org.pendant.editors.dap.run.DataWatch;
import org.pendant.editors.dap.run.DebuggedRobot;
import org.pendant.script.debug.HitRule;

/** Requests about breakpoints on values: global variables, expressions, signals, registers, arm. */
final class DataBreakpoints {
  /** Values that are looked at in each frame. */
  private static final int MAX_WATCHED = 64;

  private final DebugSession session;
  private final BreakpointTable table;
  private List<DataWatch.Watched> wanted = List.of();
  private Optional<DataWatch> watch = Optional.empty();

  DataBreakpoints(DebugSession session, BreakpointTable table) {
    this.session = session;
    this.table = table;
  }

  /** Whether a value can be watched, and by which name. */
  CompletableFuture<DataBreakpointInfoResponse> info(DataBreakpointInfoArguments asked) {
    String name = asked.getName();
    Integer reference = asked.getVariablesReference();
    if (reference != null && reference > 0) {
      Optional<String> watchable = session.references().branch(reference).branch().watchable(name);
      return CompletableFuture.completedFuture(
          watchable
              .map(what -> info(what, name))
              .orElseGet(() -> none(text("notWatchable", name))));
    }
    if (WatchedSignal.of(name).isPresent()) {
      return CompletableFuture.completedFuture(info(WatchedSignal.WATCHABLE + name, name));
    }
    return LiveScope.global(session.program().run())
        .evaluate(name)
        .handle(
            (value, fault) ->
                fault == null
                    ? info(LiveScope.WATCHABLE + name, name)
                    : none(name + ": " + Refusals.words(fault)));
  }

  private static DataBreakpointInfoResponse info(String dataId, String name) {
    DataBreakpointInfoResponse response = new DataBreakpointInfoResponse();
    response.setDataId(dataId);
    response.setDescription(name);
    response.setAccessTypes(new DataBreakpointAccessType[] {DataBreakpointAccessType.WRITE});
    response.setCanPersist(true);
    return response;
  }

  private DataBreakpointInfoResponse none(String why) {
    DataBreakpointInfoResponse response = new DataBreakpointInfoResponse();
    response.setDescription(session.form().shown(why));
    return response;
  }

  SetDataBreakpointsResponse set(SetDataBreakpointsArguments asked) {
    List<DataWatch.Watched> all = new ArrayList<>();
    List<Breakpoint> told = new ArrayList<>();
    for (DataBreakpoint each :
        Objects.requireNonNullElse(asked.getBreakpoints(), new DataBreakpoint[0])) {
      told.add(add(each, all));
    }
    wanted = List.copyOf(all);
    apply();
    SetDataBreakpointsResponse response = new SetDataBreakpointsResponse();
    response.setBreakpoints(told.toArray(Breakpoint[]::new));
    return response;
  }

  private Breakpoint add(DataBreakpoint asked, List<DataWatch.Watched> all) {
    Breakpoint told = new Breakpoint();
    told.setId(table.nextId());
    told.setVerified(true);
    Optional<HitRule> rule = HitRule.of(Objects.requireNonNullElse(asked.getHitCondition(), ""));
    Optional<DataWatch.Reader> reader = reader(asked.getDataId());
    String refusal =
        all.size() >= MAX_WATCHED
            ? text("tooManyWatched", MAX_WATCHED)
            : rule.isEmpty()
                ? text("wrongHitCondition", asked.getHitCondition(), HitRule.forms())
                : reader.isEmpty() ? text("noSuchValue", asked.getDataId()) : "";
    if (!refusal.isEmpty()) {
      BreakpointRequests.unverified(
          told, refusal, session.form(), BreakpointNotVerifiedReason.FAILED);
      return told;
    }
    String name = asked.getDataId().substring(asked.getDataId().indexOf(':') + 1);
    all.add(
        new DataWatch.Watched(
            told.getId(),
            name,
            reader.get(),
            Objects.requireNonNullElse(asked.getCondition(), "").strip(),
            rule.get()));
    return told;
  }

  private static Optional<DataWatch.Reader> reader(String dataId) {
    if (dataId == null) {
      return Optional.empty();
    }
    if (dataId.startsWith(LiveScope.WATCHABLE)) {
      return Optional.of(DataWatch.expression(dataId.substring(LiveScope.WATCHABLE.length())));
    }
    return dataId.startsWith(WatchedSignal.WATCHABLE)
        ? WatchedSignal.of(dataId.substring(WatchedSignal.WATCHABLE.length()))
            .map(signal -> (debugger, state) -> signal.text(state))
        : Optional.empty();
  }

  /** Has the robot of the session look at them. */
  void apply() {
    Optional<Debuggee> debuggee = session.debuggee().filter(each -> !each.arguments().noDebug());
    watch =
        debuggee
            .filter(each -> !wanted.isEmpty())
            .map(each -> new DataWatch(each.run().robot()::state, wanted));
    debuggee.ifPresent(each -> each.run().watch(watch.map(DebuggedRobot.FrameWatch.class::cast)));
  }

  /** What people change themselves stops nothing. */
  void changedByHand() {
    watch.ifPresent(DataWatch::beginAfresh);
  }

  /** The changes that have just held the program. */
  List<DataWatch.Change> changes() {
    return watch.map(DataWatch::take).orElse(List.of());
  }
}
