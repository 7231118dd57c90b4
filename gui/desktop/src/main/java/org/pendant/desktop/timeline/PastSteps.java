package org.pendant.desktop.timeline;

import java.awt.EventQueue;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.kit.fault.Faults;
import org.pendant.language.source.ByteText;
import org.pendant.recording.Moment;
import org.pendant.recording.RecordedChange;
import org.pendant.recording.RecordedCondition;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.RecordedStep;
import org.pendant.recording.Recording;
import org.pendant.recording.StepSearch;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.PauseReason;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableSample;

/**
 * Past steps: stepping back, and on again, through what a program did, from where it is stopped or
 * from the moment that people look at. The robot stays as it is. Only for the dispatch thread;
 * searches run elsewhere.
 */
public final class PastSteps {
  private final LookBack lookBack;
  private final Supplier<ControllerState> live;
  private final BooleanSupplier held;
  private final Function<RecordedProgram, List<Breakpoint>> breakpoints;
  private final Threads threads;
  private final Consumer<String> tell;
  private BiFunction<RecordedProgram, Integer, String> places =
      (ran, line) -> TimelineTexts.text("line", line);
  private Optional<String> watched = Optional.empty();
  private boolean busy;

  /**
   * Where work is done.
   *
   * @param search runs what may read a file
   * @param dispatch runs what comes of it in the thread that uses this object
   */
  record Threads(Executor search, Executor dispatch) {}

  /** A place to look at, and what is to be said of it. */
  private record Found(Moment moment, String words) {}

  /** Something to look for. */
  private interface Search {
    /** Where it is, or why there is none. */
    Result in(StepSearch search, Moment from);
  }

  /** What came of a search. */
  private record Result(Optional<Found> found, String otherwise) {}

  /**
   * From {@code live} on.
   *
   * @param held whether a debugger has paused any program of the cell: time stands still
   * @param breakpoints those of a program of the recording, with lines of its text
   */
  PastSteps(
      LookBack lookBack,
      Supplier<ControllerState> live,
      BooleanSupplier held,
      Function<RecordedProgram, List<Breakpoint>> breakpoints,
      Threads threads,
      Consumer<String> tell) {
    this.lookBack = lookBack;
    this.live = live;
    this.held = held;
    this.breakpoints = breakpoints;
    this.threads = threads;
    this.tell = tell;
  }

  /** As the constructor, with threads for a window. */
  public static PastSteps of(
      LookBack lookBack,
      Supplier<ControllerState> live,
      BooleanSupplier held,
      Function<RecordedProgram, List<Breakpoint>> breakpoints,
      Consumer<String> tell) {
    Threads threads =
        new Threads(
            task -> Thread.ofVirtual().name("past-steps").start(task), EventQueue::invokeLater);
    return new PastSteps(lookBack, live, held, breakpoints, threads, tell);
  }

  /** Calls lines of programs that ran so in what is told. */
  public void nameLinesBy(BiFunction<RecordedProgram, Integer, String> names) {
    places = names;
  }

  /** Whether people look at the past. */
  public boolean back() {
    return lookBack.back();
  }

  /** Back to now. */
  public void live() {
    lookBack.live();
  }

  /** Why nobody can go back from here; empty if they can. */
  public String whyNoBack() {
    return lookBack.back()
            || held.getAsBoolean()
            || ProgramPhase.of(live.get()) != ProgramPhase.RUNNING
        ? ""
        : TimelineTexts.text("pauseTheProgramFirstOrLook");
  }

  /** Why nobody can go on through the recording; empty if they can. */
  public String whyNoOn() {
    return lookBack.back() ? "" : TimelineTexts.text("thatIsForThePastStep");
  }

  /** To where the statement began, or the one before. */
  public void stepBack() {
    begin(
        (search, from) ->
            step(search.before(from), TimelineTexts.text("theRecordingHasNoEarlierStatement")));
  }

  /** To the next statement of the recording. */
  public void stepOn() {
    begin(
        (search, from) ->
            step(search.after(from), TimelineTexts.text("theRecordingHasNoLaterStatement")));
  }

  /** To the last breakpoint that the program came to before. */
  public void breakpointBefore() {
    Passing passing = passing();
    begin(
        (search, from) ->
            step(
                search.before(from, passing.lines(), passing::stops),
                passing.told(TimelineTexts.text("noEarlierBreakpoint"))));
  }

  /** To the next breakpoint that the program came to. */
  public void breakpointAfter() {
    Passing passing = passing();
    begin(
        (search, from) ->
            step(
                search.after(from, passing.lines(), passing::stops),
                passing.told(TimelineTexts.text("noLaterBreakpoint"))));
  }

  private Passing passing() {
    lookBack.newest(live.get());
    return new Passing(lookBack.recording());
  }

  /** Has {@link #changeBefore} and {@link #changeAfter} be about an expression from now on. */
  public void watch(String expression) {
    watched = Optional.of(expression);
  }

  /** Why no change can be looked for; empty if one can. */
  public String whyNoChange() {
    if (watched.isEmpty()) {
      return TimelineTexts.text("selectAVariableInVariablesOr");
    }
    return VariablePath.isOne(watched.get())
        ? whyNoBack()
        : TimelineTexts.text("isNoVariableRecordingsHaveVariables", watched.get());
  }

  /** To where the watched variable got the value that it has. */
  public void changeBefore() {
    change(false);
  }

  /** To where the watched variable gets its next value. */
  public void changeAfter() {
    change(true);
  }

  private void change(boolean forward) {
    watched.ifPresent(
        expression -> {
          VariablePath path = VariablePath.of(ByteText.asBytes(expression));
          begin(
              (search, from) ->
                  new Result(
                      (forward ? search.changeAfter(from, path) : search.changeBefore(from, path))
                          .map(change -> new Found(change.moment(), words(expression, change))),
                      TimelineTexts.text(
                          forward ? "noLaterChange" : "noEarlierChange", expression)));
        });
  }

  private static String words(String expression, RecordedChange change) {
    String after = change.after().map(PastSteps::text).orElse(TimelineTexts.text("nothing"));
    return change
        .before()
        .flatMap(VariableSample::value)
        .map(
            before ->
                TimelineTexts.text("changedFromTo", expression, text(change.before().get()), after))
        .orElseGet(() -> TimelineTexts.text("became", expression, after));
  }

  private static String text(VariableSample sample) {
    return ByteText.decoded(sample.variable().text());
  }

  private static Result step(Optional<RecordedStep> step, String otherwise) {
    return new Result(step.map(each -> new Found(each.moment(), "")), otherwise);
  }

  private void begin(Search search) {
    if (busy) {
      return;
    }
    busy = true;
    Optional<Moment> looked = lookBack.pointedAt();
    Moment from = lookBack.newest(live.get());
    Recording recording = lookBack.recording();
    threads
        .search()
        .execute(
            () -> {
              Optional<Result> result = result(search, recording, from);
              threads.dispatch().execute(() -> done(result, looked));
            });
  }

  /** Empty after a fault of ours. */
  private static Optional<Result> result(Search search, Recording recording, Moment from) {
    try {
      return Optional.of(search.in(new StepSearch(recording), from));
    } catch (UncheckedIOException e) {
      return Optional.of(
          new Result(
              Optional.empty(),
              TimelineTexts.text("theRecordingCanNoLongerBe", e.getCause().getMessage())));
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
      return Optional.empty();
    }
  }

  private void done(Optional<Result> result, Optional<Moment> looked) {
    busy = false;
    if (result.isEmpty() || !lookBack.pointedAt().equals(looked)) {
      return; // people look at something else meanwhile
    }
    Optional<Found> found = result.get().found();
    if (found.isEmpty()) {
      tell.accept(result.get().otherwise());
      return;
    }
    lookBack.jump(found.get().moment());
    if (!found.get().words().isEmpty()) {
      tell.accept(found.get().words());
    }
  }

  /** Whether a step is at a breakpoint. */
  private final class Passing {
    private final Map<RecordedProgram, List<Named>> known = new HashMap<>();
    private final Map<String, RecordedCondition> conditions = new HashMap<>();
    private final Recording recording;
    private Optional<String> untold = Optional.empty();

    /** A breakpoint, and what its line is called: only the dispatch thread knows. */
    private record Named(Breakpoint breakpoint, String place) {}

    /** Asks for breakpoints before the search begins. */
    Passing(Recording recording) {
      this.recording = recording;
      for (RecordedProgram each : recording.programs()) {
        known.put(
            each,
            breakpoints.apply(each).stream()
                .map(set -> new Named(set, places.apply(each, set.line())))
                .toList());
      }
    }

    /** The lines that have a breakpoint in any program. */
    Set<Integer> lines() {
      return known.values().stream()
          .flatMap(List::stream)
          .map(each -> each.breakpoint().line())
          .collect(Collectors.toSet());
    }

    boolean stops(RecordedStep step) {
      Optional<RecordedProgram> ran = recording.programOf(step.moment().frame());
      return ran.stream()
          .flatMap(each -> known.getOrDefault(each, List.of()).stream())
          .filter(each -> each.breakpoint().line() == step.line())
          .anyMatch(each -> stoppedBy(step) || holds(each, step));
    }

    private static boolean stoppedBy(RecordedStep step) {
      return step.stop()
          .filter(stop -> stop.reason() instanceof PauseReason.AtBreakpoint)
          .isPresent();
    }

    private boolean holds(Named named, RecordedStep step) {
      Optional<Boolean> holds =
          conditions
              .computeIfAbsent(named.breakpoint().condition(), RecordedCondition::new)
              .holds(step.variables());
      if (holds.isEmpty()) {
        untold = Optional.of(named.place());
      }
      return holds.orElse(false);
    }

    /** What is said of a search that found nothing, with what it may have missed. */
    String told(String nothing) {
      if (untold.isPresent()) {
        return TimelineTexts.text("conditionUnknown", nothing, untold.get());
      }
      return lines().isEmpty() ? nothing : TimelineTexts.text("laterOnesNotFound", nothing);
    }
  }
}
