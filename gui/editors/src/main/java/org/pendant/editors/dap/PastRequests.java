package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.eclipse.lsp4j.debug.StoppedEventArgumentsReason;
import org.pendant.editors.dap.look.PastView;
import org.pendant.editors.dap.look.StandingProgram;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.Moment;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.RecordedStep;
import org.pendant.recording.Recording;
import org.pendant.recording.StepSearch;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;

/**
 * Requests that lead through what a program has done: back from where it stands, and on again up to
 * there. The robot stays as it is.
 */
final class PastRequests {
  private final DebugSession session;
  private final BreakpointTable table;
  private final ProgressEvents progress;
  private Optional<StandingProgram> live = Optional.empty();
  private final Map<Integer, CompletableFuture<?>> searching = new HashMap<>();

  PastRequests(DebugSession session, BreakpointTable table, ProgressEvents progress) {
    this.progress = progress;
    this.session = session;
    this.table = table;
  }

  /**
   * A moment that was found.
   *
   * @param moment empty for now
   * @param reason as the protocol calls it
   * @param words about it
   */
  private record Found(Optional<Moment> moment, String reason, String words) {
    static final Found NOW =
        new Found(Optional.empty(), StoppedEventArgumentsReason.STEP, text("backToNow"));
  }

  /** Something to look for; it fails with the reason why there is none. */
  private interface Search {
    Found in(Recording recording, Moment from, Moment now);
  }

  /** Whether the client looks at the past. */
  boolean past() {
    return session.view().filter(PastView.class::isInstance).isPresent();
  }

  /** To where the statement began, or the one before. */
  CompletableFuture<Void> stepBack() {
    return begin(
        (recording, from, now) ->
            new StepSearch(recording)
                .before(from)
                .map(step -> found(step, StoppedEventArgumentsReason.STEP))
                .orElseThrow(() -> Refusals.of(text("noEarlierStatement"))));
  }

  /** To the frame before. */
  CompletableFuture<Void> frameBack() {
    return begin(
        (recording, from, now) -> {
          if (from.frame() <= recording.firstFrame()) {
            throw Refusals.of(text("noEarlierFrame"));
          }
          return new Found(
              Optional.of(Moment.endOf(from.frame() - 1)), StoppedEventArgumentsReason.STEP, "");
        });
  }

  /** To the moment at which a line of output was written. */
  CompletableFuture<Void> to(WrittenLines.Written written) {
    return begin(
        (recording, from, now) -> {
          if (written.moment().frame() < recording.firstFrame()) {
            throw Refusals.of(text("outputNotRecorded"));
          }
          return until(
              now,
              Optional.of(
                  new Found(
                      Optional.of(written.moment()),
                      StoppedEventArgumentsReason.GOTO,
                      text("hereWritten", written.text()))));
        });
  }

  /** To a robot time, s. */
  CompletableFuture<Void> to(double timeS) {
    return begin(
        (recording, from, now) ->
            until(
                now,
                Optional.of(
                    new Found(
                        Optional.of(Moment.endOf(recording.frameAt(timeS))),
                        StoppedEventArgumentsReason.GOTO,
                        ""))));
  }

  /** Gives up the search that the client's request of this number has begun, if it is under way. */
  void cancel(int request) {
    Optional.ofNullable(searching.get(request)).ifPresent(search -> search.cancel(true));
  }

  /** To the next statement. */
  CompletableFuture<Void> stepOn() {
    return begin(
        (recording, from, now) ->
            until(
                now,
                new StepSearch(recording)
                    .after(from)
                    .map(step -> found(step, StoppedEventArgumentsReason.STEP))));
  }

  /** To where the last move began. */
  CompletableFuture<Void> moveBack(Moves moves) {
    return begin(
        (recording, from, now) ->
            new StepSearch(recording)
                .before(from, moves.lines(), step -> true)
                .map(step -> toMove(step, moves))
                .orElseThrow(() -> Refusals.of(text("noEarlierMove"))));
  }

  /** To where the next move begins, or to the statement behind the one that is looked at. */
  CompletableFuture<Void> moveOn(Moves moves) {
    StandingProgram view = session.stopped();
    boolean within = moves.lines().contains(view.threads().getFirst().line());
    return begin(
        (recording, from, now) -> {
          StepSearch search = new StepSearch(recording);
          Optional<RecordedStep> next =
              within ? search.after(from) : search.after(from, moves.lines(), step -> true);
          return until(now, next.map(step -> toMove(step, moves)));
        });
  }

  private static Found toMove(RecordedStep step, Moves moves) {
    return new Found(
        Optional.of(step.moment()), StoppedEventArgumentsReason.STEP, moves.words(step.line()));
  }

  /** To the next frame. */
  CompletableFuture<Void> frameOn() {
    return begin(
        (recording, from, now) ->
            until(
                now,
                Optional.of(
                    new Found(
                        Optional.of(Moment.endOf(from.frame() + 1)),
                        StoppedEventArgumentsReason.STEP,
                        ""))));
  }

  /** To the last breakpoint that the program came to before, or to where it began. */
  CompletableFuture<Void> reverseContinue() {
    PastBreakpoints breakpoints = breakpoints();
    return begin(
        (recording, from, now) ->
            new StepSearch(recording)
                .before(from, breakpoints.lines(), breakpoints::stop)
                .map(step -> found(step, StoppedEventArgumentsReason.BREAKPOINT))
                .orElseGet(() -> beginning(recording, from, breakpoints)));
  }

  private static Found beginning(Recording recording, Moment from, PastBreakpoints breakpoints) {
    long frame =
        recording
            .programOf(from.frame())
            .map(RecordedProgram::frame)
            .orElse(recording.firstFrame());
    return new StepSearch(recording)
        .after(Moment.endOf(frame - 1))
        .map(RecordedStep::moment)
        .filter(moment -> moment.compareTo(from) < 0)
        .map(
            moment ->
                new Found(
                    Optional.of(moment),
                    StoppedEventArgumentsReason.ENTRY,
                    breakpoints.said(text("beginning"))))
        .orElseThrow(() -> Refusals.of(breakpoints.said(text("noEarlierBreakpoint"))));
  }

  /** To the next breakpoint that the program came to, or to now. */
  CompletableFuture<Void> resume() {
    PastBreakpoints breakpoints = breakpoints();
    return begin(
        (recording, from, now) ->
            until(
                now,
                new StepSearch(recording)
                    .after(from, breakpoints.lines(), breakpoints::stop)
                    .map(step -> found(step, StoppedEventArgumentsReason.BREAKPOINT))));
  }

  private static Found found(RecordedStep step, String reason) {
    return new Found(Optional.of(step.moment()), reason, "");
  }

  /** What is found, or now where that is not before now. */
  private static Found until(Moment now, Optional<Found> found) {
    return found
        .filter(each -> each.moment().filter(moment -> moment.compareTo(now) < 0).isPresent())
        .orElse(Found.NOW);
  }

  private PastBreakpoints breakpoints() {
    Debuggee debuggee = session.program();
    SortedMap<Integer, Breakpoint> byStatement = new TreeMap<>();
    for (Breakpoint each : table.wanted(debuggee.text()::isMeant).values()) {
      OptionalInt line = debuggee.text().statementLine(debuggee.program(), each.line());
      if (line.isPresent()) {
        byStatement.put(line.getAsInt(), each);
      }
    }
    return new PastBreakpoints(byStatement);
  }

  /** Searches elsewhere: a long recording takes some time. */
  private CompletableFuture<Void> begin(Search search) {
    StandingProgram before = session.stopped();
    if (!(before instanceof PastView)) {
      live = Optional.of(before);
    }
    StandingProgram now = live.orElseThrow();
    Debuggee debuggee = session.program();
    Supplier<Arrival> work =
        () -> {
          Recording recording = debuggee.run().recording();
          Found found = search.in(recording, moment(before), Moment.of(now.state()));
          return arrival(debuggee, recording, found, now);
        };
    CompletableFuture<Arrival> found =
        CompletableFuture.supplyAsync(
            work, task -> Thread.ofVirtual().name("past steps").start(task));
    session
        .thread()
        .asked()
        .ifPresent(
            request -> {
              searching.put(request, found);
              var _ =
                  found.whenCompleteAsync(
                      (arrival, fault) -> searching.remove(request), session.thread());
            });
    return progress
        .of(text("searching"), true, found)
        // so that a refusal takes its turn as well
        .whenCompleteAsync((arrival, fault) -> {}, session.thread())
        .thenAccept(arrival -> arrive(before, arrival));
  }

  private void arrive(StandingProgram before, Arrival arrival) {
    if (session.view().filter(view -> view.equals(before)).isEmpty()) {
      throw Refusals.of(text("goneOnMeanwhile"));
    }
    session.goOn();
    // behind the answer to this request
    session.thread().execute(() -> session.stop(arrival.view(), arrival.told()));
  }

  private static Moment moment(StandingProgram of) {
    return of instanceof PastView past ? past.moment() : Moment.of(of.state());
  }

  /** Where a request leads. */
  private record Arrival(StandingProgram view, StoppedEventArguments told) {}

  private static Arrival arrival(
      Debuggee debuggee, Recording recording, Found found, StandingProgram now) {
    StoppedEventArguments told = new StoppedEventArguments();
    told.setReason(found.reason());
    if (found.moment().isEmpty()) {
      told.setDescription(found.words());
      told.setThreadId(DebugSession.number(thread(now)));
      return new Arrival(now, told);
    }
    Moment moment = found.moment().get();
    PastView view = PastView.of(moment, recording.at(moment), debuggee.text().source());
    String then = seconds(moment.frame());
    String current = seconds(now.state().frame());
    told.setDescription(
        found.words().isEmpty()
            ? text("inThePast", then, current)
            : text("inThePastBecause", then, current, found.words()));
    told.setThreadId(DebugSession.number(thread(view)));
    return new Arrival(view, told);
  }

  private static int thread(StandingProgram view) {
    return view.state().debug().stop().map(stop -> stop.thread()).orElse(Debugger.MAIN);
  }

  private static String seconds(long frame) {
    return String.format(Locale.ROOT, "%.3f s", frame / (double) FrameTime.FRAMES_PER_SECOND);
  }
}
