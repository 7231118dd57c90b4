package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.debug.GotoArguments;
import org.eclipse.lsp4j.debug.GotoTarget;
import org.eclipse.lsp4j.debug.GotoTargetsArguments;
import org.eclipse.lsp4j.debug.GotoTargetsResponse;
import org.eclipse.lsp4j.debug.LoadedSourcesResponse;
import org.eclipse.lsp4j.debug.Source;
import org.eclipse.lsp4j.debug.SourceArguments;
import org.eclipse.lsp4j.debug.SourceResponse;
import org.pendant.language.source.ByteText;

/** Requests about the text of the program. */
final class SourceRequests {
  /** Moments of a line that are offered, the newest. */
  private static final int MAX_MOMENTS = 20;

  private final DebugSession session;
  private final ExecutionRequests execution;

  SourceRequests(DebugSession session, ExecutionRequests execution) {
    this.session = session;
    this.execution = execution;
  }

  /** The text as it runs, which no file has where it was made of a tree. */
  SourceResponse source(SourceArguments asked) {
    DebuggedText text = session.program().text();
    Source named = asked.getSource();
    if (named == null) {
      named = new Source();
      named.setSourceReference(asked.getSourceReference());
    }
    if (!text.isMeant(named)) {
      throw Refusals.of(text("noSuchText", text.source().name()));
    }
    SourceResponse response = new SourceResponse();
    response.setContent(ByteText.decoded(text.source().text()));
    return response;
  }

  LoadedSourcesResponse loaded() {
    LoadedSourcesResponse response = new LoadedSourcesResponse();
    response.setSources(
        session.debuggee().map(Debuggee::text).map(DebuggedText::asSource).stream()
            .toArray(Source[]::new));
    return response;
  }

  /** Where a program can go on to: it carries out what is between. */
  GotoTargetsResponse targets(GotoTargetsArguments asked) {
    Debuggee debuggee = session.program();
    if (!debuggee.text().isMeant(asked.getSource())) {
      throw Refusals.of(text("notInDebugged", debuggee.text().source().name()));
    }
    int wanted = session.form().fromLine(asked.getLine());
    OptionalInt line = debuggee.text().statementLine(debuggee.program(), wanted);
    if (line.isEmpty()) {
      throw Refusals.of(text("noStatementHere"));
    }
    List<GotoTarget> targets = new ArrayList<>();
    targets.add(target(line.getAsInt(), line.getAsInt(), text("runToLine", line.getAsInt())));
    List<WrittenLines.Written> written =
        debuggee.events().written().all().stream()
            .filter(each -> each.line() == wanted)
            .toList()
            .reversed();
    written.stream()
        .limit(MAX_MOMENTS)
        .forEach(each -> targets.add(target(-each.id(), wanted, label(each))));
    GotoTargetsResponse response = new GotoTargetsResponse();
    response.setTargets(targets.toArray(GotoTarget[]::new));
    return response;
  }

  private GotoTarget target(int id, int line, String label) {
    GotoTarget target = new GotoTarget();
    target.setId(id);
    target.setLabel(session.form().shown(label));
    target.setLine(session.form().line(line));
    return target;
  }

  private static String label(WrittenLines.Written written) {
    String then = String.format(Locale.ROOT, "%.3f s", written.timeS());
    return text("backToWritten", then, written.text());
  }

  /** To a line, or to a moment of the past. */
  CompletableFuture<Void> goTo(GotoArguments asked) {
    return asked.getTargetId() < 0
        ? execution.toMoment(-asked.getTargetId())
        : execution.runTo(asked.getThreadId(), asked.getTargetId());
  }
}
