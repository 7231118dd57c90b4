package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.eclipse.lsp4j.debug.ContinuedEventArguments;
import org.eclipse.lsp4j.debug.InvalidatedEventArguments;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.eclipse.lsp4j.debug.ThreadEventArguments;
import org.eclipse.lsp4j.debug.ThreadEventArgumentsReason;
import org.eclipse.lsp4j.debug.services.IDebugProtocolClient;
import org.pendant.editors.dap.look.StandingProgram;
import org.pendant.editors.dap.run.DebuggedRobot;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ThreadSnapshot;

/** Debug session: what all requests of a client have in common. Only its thread uses it. */
final class DebugSession {
  private final SessionThread thread;
  private final Supplier<IDebugProtocolClient> client;
  private final References references = new References();
  private final List<Integer> toldThreads = new ArrayList<>();
  private volatile ClientForm form = ClientForm.STANDARD;
  private boolean paging;
  private Optional<Debuggee> debuggee = Optional.empty();
  private Optional<StandingProgram> view = Optional.empty();

  DebugSession(SessionThread thread, Supplier<IDebugProtocolClient> client) {
    this.thread = thread;
    this.client = client;
  }

  SessionThread thread() {
    return thread;
  }

  IDebugProtocolClient client() {
    return client.get();
  }

  References references() {
    return references;
  }

  /** How the client wants to be told things; for any thread. */
  ClientForm form() {
    return form;
  }

  /** Whether the client asks for long values page by page. */
  boolean paging() {
    return paging;
  }

  void talkTo(ClientForm form, boolean paging) {
    this.form = form;
    this.paging = paging;
  }

  Optional<Debuggee> debuggee() {
    return debuggee;
  }

  void debug(Optional<Debuggee> debuggee) {
    this.debuggee = debuggee;
    goOn();
    toldThreads.clear();
  }

  /** The program, which must be there. */
  Debuggee program() {
    return debuggee.orElseThrow(() -> Refusals.of(text("notLaunched")));
  }

  /** The moment that is looked at, while the program stands still. */
  Optional<StandingProgram> view() {
    return view;
  }

  /** The same, which must be there. */
  StandingProgram stopped() {
    return view.orElseThrow(() -> Refusals.of(text("notStopped")));
  }

  /** The program goes on. */
  void goOn() {
    view = Optional.empty();
    references.clear();
  }

  /** The program stands still: the client looks at a moment. */
  void stop(StandingProgram moment, StoppedEventArguments told) {
    goOn();
    view = Optional.of(moment);
    tellThreads(moment.threads().stream().map(ThreadSnapshot::id).toList());
    told.setAllThreadsStopped(true);
    Optional.ofNullable(told.getDescription()).map(form::shown).ifPresent(told::setDescription);
    Optional.ofNullable(told.getText()).map(form::shown).ifPresent(told::setText);
    client().stopped(told);
  }

  /** Tells that the program goes on, where no request says so by itself. */
  void tellContinued() {
    ContinuedEventArguments told = new ContinuedEventArguments();
    told.setThreadId(number(Debugger.MAIN));
    told.setAllThreadsContinued(true);
    client().continued(told);
  }

  /**
   * What a request of ours leads away from where the program stands: the client, which knows
   * nothing of such requests, is told before it stands elsewhere.
   */
  CompletableFuture<Void> leadingAway(CompletableFuture<Void> request) {
    return request.thenRun(this::tellContinued);
  }

  /**
   * Something has changed of what the client looks at.
   *
   * @param area of it, in the protocol's words
   */
  void change(StandingProgram now, String area) {
    view = Optional.of(now);
    tellThreads(now.threads().stream().map(ThreadSnapshot::id).toList());
    tellChanged(area);
  }

  /** Tells that the client should look again, where it understands that. */
  void tellChanged(String area) {
    if (form.invalidated()) {
      InvalidatedEventArguments told = new InvalidatedEventArguments();
      told.setAreas(new String[] {area});
      client().invalidated(told);
    }
  }

  /** Tells which threads have begun and ended since the last time. */
  void tellThreads(List<Integer> now) {
    Stream.concat(now.stream(), toldThreads.stream())
        .distinct()
        .filter(id -> now.contains(id) != toldThreads.contains(id))
        .forEach(
            id -> {
              ThreadEventArguments told = new ThreadEventArguments();
              told.setThreadId(number(id));
              told.setReason(
                  now.contains(id)
                      ? ThreadEventArgumentsReason.STARTED
                      : ThreadEventArgumentsReason.EXITED);
              client().thread(told);
            });
    toldThreads.clear();
    toldThreads.addAll(now);
  }

  /** The client's number of a thread: some clients take 0 for none. */
  static int number(int thread) {
    return thread + 1;
  }

  /** The thread that the client calls {@code number}. */
  static int thread(int number) {
    return number - 1;
  }

  /** Asks the debugger. */
  <T> CompletableFuture<T> ask(DebuggedRobot.Question<T> question) {
    return program().run().ask(question);
  }
}
