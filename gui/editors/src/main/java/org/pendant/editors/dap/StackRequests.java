package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.debug.Scope;
import org.eclipse.lsp4j.debug.ScopesResponse;
import org.eclipse.lsp4j.debug.StackFrame;
import org.eclipse.lsp4j.debug.StackFramePresentationHint;
import org.eclipse.lsp4j.debug.StackTraceArguments;
import org.eclipse.lsp4j.debug.StackTraceResponse;
import org.eclipse.lsp4j.debug.Thread;
import org.eclipse.lsp4j.debug.ThreadsResponse;
import org.pendant.editors.dap.look.Branch;
import org.pendant.editors.dap.look.StandingProgram;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ThreadSnapshot;

/** Requests about where a program stands: threads, calls and what can be seen from them. */
final class StackRequests {
  private final DebugSession session;

  StackRequests(DebugSession session) {
    this.session = session;
  }

  CompletableFuture<ThreadsResponse> threads() {
    Optional<StandingProgram> view = session.view();
    if (view.isPresent()) {
      return CompletableFuture.completedFuture(told(view.get().threads()));
    }
    return session
        .ask(Debugger::threads)
        .thenApply(
            threads -> {
              session.tellThreads(
                  threads.isEmpty()
                      ? List.of(Debugger.MAIN)
                      : threads.stream().map(ThreadSnapshot::id).toList());
              return told(threads);
            });
  }

  private ThreadsResponse told(List<ThreadSnapshot> threads) {
    List<Thread> all = new ArrayList<>();
    threads.stream().limit(Branch.MOST).map(StackRequests::told).forEach(all::add);
    if (all.isEmpty()) {
      Thread main = new Thread();
      main.setId(DebugSession.number(Debugger.MAIN));
      main.setName(ByteText.decoded(session.program().program().name()));
      all.add(main);
    }
    ThreadsResponse response = new ThreadsResponse();
    response.setThreads(all.toArray(Thread[]::new));
    return response;
  }

  private static Thread told(ThreadSnapshot thread) {
    Thread told = new Thread();
    told.setId(DebugSession.number(thread.id()));
    String waits = thread.waitsFor().isEmpty() ? "" : " (in " + thread.waitsFor() + ")";
    told.setName(ByteText.decoded(thread.name()) + waits);
    return told;
  }

  StackTraceResponse stackTrace(StackTraceArguments asked) {
    int id = DebugSession.thread(asked.getThreadId());
    List<ThreadSnapshot.Level> stack =
        session.stopped().threads().stream()
            .filter(each -> each.id() == id)
            .findFirst()
            .orElseThrow(() -> Refusals.of(text("noSuchThread", asked.getThreadId())))
            .stack();
    int start = Math.max(0, Objects.requireNonNullElse(asked.getStartFrame(), 0));
    int levels = Objects.requireNonNullElse(asked.getLevels(), 0);
    int count = levels <= 0 ? Branch.MOST : Math.min(levels, Branch.MOST);
    List<StackFrame> frames = new ArrayList<>();
    for (int i = start; i < stack.size() && i - start < count; i++) {
      frames.add(told(stack.get(i), new References.Frame(id, stack.size() - i)));
    }
    StackTraceResponse response = new StackTraceResponse();
    response.setStackFrames(frames.toArray(StackFrame[]::new));
    response.setTotalFrames(stack.size());
    return response;
  }

  private StackFrame told(ThreadSnapshot.Level level, References.Frame frame) {
    DebuggedText text = session.program().text();
    StackFrame told = new StackFrame();
    told.setId(session.references().of(frame));
    told.setName(ByteText.decoded(level.function()));
    if (level.source().equals(text.source().name())) {
      DebuggedText.Place start = text.place(level.range().start());
      DebuggedText.Place end = text.place(level.range().end());
      told.setSource(text.asSource());
      told.setLine(start.line());
      told.setColumn(start.column());
      told.setEndLine(end.line());
      told.setEndColumn(end.column());
    } else {
      // a line of interpreter mode, which no text has
      told.setPresentationHint(StackFramePresentationHint.SUBTLE);
      told.setLine(0);
      told.setColumn(0);
    }
    return told;
  }

  CompletableFuture<ScopesResponse> scopes(int frameId) {
    References.Frame frame = session.references().frame(frameId);
    return session
        .stopped()
        .scopes(frame.thread(), frame.depth())
        .thenApply(
            scopes -> {
              ScopesResponse response = new ScopesResponse();
              response.setScopes(
                  scopes.stream().map(each -> told(each, frame)).toArray(Scope[]::new));
              return response;
            });
  }

  private Scope told(StandingProgram.Scope scope, References.Frame frame) {
    Scope told = new Scope();
    told.setName(session.form().shown(scope.name()));
    if (!scope.kind().isEmpty()) {
      told.setPresentationHint(scope.kind());
    }
    told.setVariablesReference(session.references().of(scope.branch(), frame));
    told.setNamedVariables(scope.branch().size());
    told.setExpensive(false);
    return told;
  }
}
