package org.pendant.editors.dap;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.debug.Breakpoint;
import org.eclipse.lsp4j.debug.BreakpointEventArguments;
import org.eclipse.lsp4j.debug.BreakpointEventArgumentsReason;
import org.eclipse.lsp4j.debug.BreakpointLocation;
import org.eclipse.lsp4j.debug.BreakpointLocationsArguments;
import org.eclipse.lsp4j.debug.BreakpointLocationsResponse;
import org.eclipse.lsp4j.debug.BreakpointNotVerifiedReason;
import org.eclipse.lsp4j.debug.SetBreakpointsArguments;
import org.eclipse.lsp4j.debug.SetBreakpointsResponse;
import org.eclipse.lsp4j.debug.Source;
import org.eclipse.lsp4j.debug.SourceBreakpoint;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.HitRule;

/** Requests about breakpoints on lines. */
final class BreakpointRequests {
  private static final int MAX_LOCATIONS = 1000;

  private final DebugSession session;
  private final BreakpointTable table;
  private final BreakpointCheck check;

  BreakpointRequests(DebugSession session, BreakpointTable table, Catalogue catalogue) {
    this.session = session;
    this.table = table;
    check = new BreakpointCheck(catalogue);
  }

  CompletableFuture<SetBreakpointsResponse> set(SetBreakpointsArguments wanted) {
    SourceBreakpoint[] asked =
        Objects.requireNonNullElse(wanted.getBreakpoints(), new SourceBreakpoint[0]);
    List<BreakpointTable.Wanted> all = new ArrayList<>();
    for (SourceBreakpoint each : asked) {
      all.add(wanted(wanted.getSource(), each, all.size()));
    }
    table.set(wanted.getSource(), all);
    SetBreakpointsResponse response = new SetBreakpointsResponse();
    response.setBreakpoints(
        all.stream().map(each -> told(wanted.getSource(), each)).toArray(Breakpoint[]::new));
    return install().thenApply(done -> response);
  }

  private BreakpointTable.Wanted wanted(Source source, SourceBreakpoint asked, int before) {
    int line = session.form().fromLine(asked.getLine());
    String condition = Objects.requireNonNullElse(asked.getCondition(), "");
    String message = Objects.requireNonNullElse(asked.getLogMessage(), "");
    String hits = Objects.requireNonNullElse(asked.getHitCondition(), "");
    Optional<HitRule> rule = HitRule.of(hits);
    Optional<String> refusal =
        before >= BreakpointTable.MOST
            ? Optional.of(DebugAdapterTexts.text("tooManyBreakpoints", BreakpointTable.MOST))
            : rule.isEmpty()
                ? Optional.of(DebugAdapterTexts.text("wrongHitCondition", hits, HitRule.forms()))
                : text(source).flatMap(text -> check.refusal(text, line, condition, message));
    Optional<org.pendant.script.debug.Breakpoint> breakpoint =
        refusal.isPresent()
            ? Optional.empty()
            : Optional.of(
                new org.pendant.script.debug.Breakpoint(
                    line,
                    true,
                    ByteText.asBytes(condition),
                    rule.get(),
                    ByteText.asBytes(message)));
    return new BreakpointTable.Wanted(table.nextId(), line, breakpoint, refusal);
  }

  private Optional<DebuggedText> text(Source source) {
    return session
        .debuggee()
        .map(Debuggee::text)
        .filter(DebuggedText::known)
        .filter(text -> text.isMeant(source));
  }

  /** What became of a breakpoint. */
  private Breakpoint told(Source source, BreakpointTable.Wanted wanted) {
    Breakpoint told = new Breakpoint();
    told.setId(wanted.id());
    told.setSource(source);
    told.setLine(session.form().line(wanted.line()));
    if (wanted.refusal().isPresent()) {
      unverified(told, wanted.refusal().get(), session.form(), BreakpointNotVerifiedReason.FAILED);
    } else if (session.debuggee().isEmpty() || !session.program().text().known()) {
      unverified(
          told,
          DebugAdapterTexts.text("noProgramYet"),
          session.form(),
          BreakpointNotVerifiedReason.PENDING);
    } else if (text(source).isEmpty()) {
      unverified(
          told,
          DebugAdapterTexts.text("notInDebugged", session.program().text().source().name()),
          session.form(),
          BreakpointNotVerifiedReason.FAILED);
    } else {
      place(told, wanted.line());
    }
    return told;
  }

  private void place(Breakpoint told, int line) {
    Debuggee debuggee = session.program();
    OptionalInt statement = debuggee.text().statementLine(debuggee.program(), line);
    if (statement.isEmpty()) {
      unverified(
          told,
          DebugAdapterTexts.text("noStatementHere"),
          session.form(),
          BreakpointNotVerifiedReason.FAILED);
      return;
    }
    told.setVerified(true);
    told.setLine(session.form().line(statement.getAsInt()));
    if (statement.getAsInt() != line) {
      told.setMessage(session.form().shown(DebugAdapterTexts.text("movedToStatement")));
    }
  }

  static void unverified(
      Breakpoint told, String why, ClientForm form, BreakpointNotVerifiedReason reason) {
    told.setVerified(false);
    told.setMessage(form.shown(why));
    told.setReason(reason);
  }

  /** Has the debugger have what is wanted. */
  CompletableFuture<Boolean> install() {
    Optional<Debuggee> debuggee = session.debuggee().filter(each -> !each.arguments().noDebug());
    if (debuggee.isEmpty()) {
      return CompletableFuture.completedFuture(false);
    }
    var installation = table.installation(table.wanted(debuggee.get().text()::isMeant));
    return session.ask(
        debugger -> {
          installation.accept(debugger);
          return true;
        });
  }

  /** Takes them out of a debugger that others go on with; theirs stay. */
  void uninstall() {
    if (session.debuggee().isPresent()) {
      var nothing = table.installation(new TreeMap<>());
      var _ =
          session.ask(
              debugger -> {
                nothing.accept(debugger);
                return true;
              });
    }
  }

  /** Another debugger has none of them yet. */
  void anotherDebugger() {
    table.forgetInstalled();
  }

  /** Tells what became of the breakpoints that were set before the program was there. */
  void launched() {
    for (BreakpointTable.OfSource of : table.sources()) {
      for (BreakpointTable.Wanted each : of.all()) {
        BreakpointEventArguments changed = new BreakpointEventArguments();
        changed.setReason(BreakpointEventArgumentsReason.CHANGED);
        changed.setBreakpoint(told(of.source(), each));
        session.client().breakpoint(changed);
      }
    }
  }

  /** The lines of a stretch on which a program can stop. */
  BreakpointLocationsResponse locations(BreakpointLocationsArguments asked) {
    BreakpointLocationsResponse response = new BreakpointLocationsResponse();
    Optional<DebuggedText> text = text(asked.getSource());
    if (text.isEmpty()) {
      response.setBreakpoints(new BreakpointLocation[0]);
      return response;
    }
    int first = session.form().fromLine(asked.getLine());
    int last = asked.getEndLine() == null ? first : session.form().fromLine(asked.getEndLine());
    List<Integer> lines = new ArrayList<>();
    int line = first;
    while (lines.size() < MAX_LOCATIONS) {
      OptionalInt next = text.get().statementLine(session.program().program(), line);
      if (next.isEmpty() || next.getAsInt() > last) {
        break;
      }
      lines.add(next.getAsInt());
      line = next.getAsInt() + 1;
    }
    response.setBreakpoints(
        lines.stream()
            .map(
                each -> {
                  BreakpointLocation location = new BreakpointLocation();
                  location.setLine(session.form().line(each));
                  return location;
                })
            .toArray(BreakpointLocation[]::new));
    return response;
  }

  /** Why a program stopped on a line, by the breakpoints there. */
  BreakpointTable.Hit at(int line) {
    return table.at(line, session.program().text()::isMeant);
  }
}
