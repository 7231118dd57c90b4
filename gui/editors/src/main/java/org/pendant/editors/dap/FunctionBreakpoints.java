package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.eclipse.lsp4j.debug.Breakpoint;
import org.eclipse.lsp4j.debug.BreakpointEventArguments;
import org.eclipse.lsp4j.debug.BreakpointEventArgumentsReason;
import org.eclipse.lsp4j.debug.BreakpointNotVerifiedReason;
import org.eclipse.lsp4j.debug.FunctionBreakpoint;
import org.eclipse.lsp4j.debug.SetFunctionBreakpointsArguments;
import org.eclipse.lsp4j.debug.SetFunctionBreakpointsResponse;
import org.pendant.language.service.OutlineItem;
import org.pendant.language.service.ScriptAnalysis;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.script.debug.HitRule;

/** Requests about breakpoints on functions and threads of the program: at their first statement. */
final class FunctionBreakpoints {
  private final DebugSession session;
  private final BreakpointTable table;
  private final BreakpointRequests requests;
  private final Catalogue catalogue;
  private FunctionBreakpoint[] asked = {};
  private List<Integer> ids = List.of();

  FunctionBreakpoints(
      DebugSession session,
      BreakpointTable table,
      BreakpointRequests requests,
      Catalogue catalogue) {
    this.session = session;
    this.table = table;
    this.requests = requests;
    this.catalogue = catalogue;
  }

  CompletableFuture<SetFunctionBreakpointsResponse> set(SetFunctionBreakpointsArguments wanted) {
    asked = Objects.requireNonNullElse(wanted.getBreakpoints(), new FunctionBreakpoint[0]);
    ids = Arrays.stream(asked).map(each -> table.nextId()).toList();
    SetFunctionBreakpointsResponse response = new SetFunctionBreakpointsResponse();
    response.setBreakpoints(find().stream().map(this::told).toArray(Breakpoint[]::new));
    return requests.install().thenApply(done -> response);
  }

  /** Looks for them in another program, and tells what became of them. */
  void launched() {
    for (BreakpointTable.Wanted each : find()) {
      BreakpointEventArguments changed = new BreakpointEventArguments();
      changed.setReason(BreakpointEventArgumentsReason.CHANGED);
      changed.setBreakpoint(told(each));
      session.client().breakpoint(changed);
    }
  }

  /** Looks for the functions that were asked for in the program of the session. */
  private List<BreakpointTable.Wanted> find() {
    List<OutlineItem> outline =
        asked.length == 0 || !known()
            ? List.of()
            : ScriptAnalysis.of(session.program().text().source(), catalogue).outline();
    List<BreakpointTable.Wanted> all = new ArrayList<>();
    for (int i = 0; i < asked.length; i++) {
      int id = ids.get(i);
      all.add(
          i < BreakpointTable.MOST
              ? wanted(id, asked[i], outline)
              : refused(id, text("tooManyFunctionBreakpoints", BreakpointTable.MOST)));
    }
    table.setFunctions(all);
    return all;
  }

  private static BreakpointTable.Wanted refused(int id, String why) {
    return new BreakpointTable.Wanted(id, 0, Optional.empty(), Optional.of(why));
  }

  private boolean known() {
    return session.debuggee().filter(each -> each.text().known()).isPresent();
  }

  private BreakpointTable.Wanted wanted(
      int id, FunctionBreakpoint each, List<OutlineItem> outline) {
    if (!known()) {
      return refused(id, text("noProgramYet"));
    }
    Optional<HitRule> rule = HitRule.of(Objects.requireNonNullElse(each.getHitCondition(), ""));
    if (rule.isEmpty()) {
      return refused(id, text("wrongHitCondition", each.getHitCondition(), HitRule.forms()));
    }
    if (each.getName() == null) {
      return refused(id, text("functionNameMissing"));
    }
    Optional<OutlineItem> function =
        definitions(outline)
            .filter(item -> item.name().equals(ByteText.asBytes(each.getName().strip())))
            .findFirst();
    if (function.isEmpty()) {
      return refused(id, text("noSuchFunction", each.getName()));
    }
    OptionalInt line = firstStatement(function.get());
    if (line.isEmpty()) {
      return refused(id, text("functionWithoutStatement", each.getName()));
    }
    org.pendant.script.debug.Breakpoint breakpoint =
        new org.pendant.script.debug.Breakpoint(
            line.getAsInt(),
            true,
            ByteText.asBytes(Objects.requireNonNullElse(each.getCondition(), "")),
            rule.get(),
            "");
    return new BreakpointTable.Wanted(
        id, line.getAsInt(), Optional.of(breakpoint), Optional.empty());
  }

  private static Stream<OutlineItem> definitions(List<OutlineItem> among) {
    return among.stream()
        .filter(each -> each.kind() != OutlineItem.Kind.GLOBAL)
        .flatMap(each -> Stream.concat(Stream.of(each), definitions(each.children())));
  }

  /** The line of the first statement that is in no definition within it. */
  private OptionalInt firstStatement(OutlineItem function) {
    Source source = session.program().text().source();
    int line = source.line(function.nameRange().start());
    while (true) {
      OptionalInt start = session.program().program().statementFrom(line);
      if (start.isEmpty() || start.getAsInt() >= function.range().end()) {
        return OptionalInt.empty();
      }
      int at = start.getAsInt();
      Optional<OutlineItem> inner =
          function.children().stream()
              .filter(each -> each.kind() != OutlineItem.Kind.GLOBAL)
              .filter(each -> each.range().start() <= at && at < each.range().end())
              .findFirst();
      if (inner.isEmpty()) {
        return OptionalInt.of(source.line(at));
      }
      line = source.line(inner.get().range().end()) + 1;
      if (line > source.lineCount()) {
        return OptionalInt.empty();
      }
    }
  }

  private Breakpoint told(BreakpointTable.Wanted wanted) {
    Breakpoint told = new Breakpoint();
    told.setId(wanted.id());
    if (wanted.refusal().isPresent()) {
      BreakpointRequests.unverified(
          told, wanted.refusal().get(), session.form(), BreakpointNotVerifiedReason.FAILED);
    } else {
      told.setVerified(true);
      told.setSource(session.program().text().asSource());
      told.setLine(session.form().line(wanted.line()));
    }
    return told;
  }
}
