package org.pendant.desktop.debug;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.WeakHashMap;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.BreakpointState;

/** Open breakpoints: the breakpoints of the open programs, and their state in the debugger. */
public final class OpenBreakpoints {
  private final DebugLink link;
  private final Programs programs;
  private final Consumer<String> tell;

  /** Closed programs keep theirs for as long as the user may open them again. */
  private final Map<ProgramDocument, BreakpointList> lists = new WeakHashMap<>();

  private Function<ProgramDocument, List<Breakpoint>> memory = program -> List.of();
  private final List<Runnable> listeners = new ArrayList<>();
  private Marks marks = this::toggleHere;
  private final StartedProgram started;
  private List<BreakpointState> states = List.of();
  private OptionalLong turns = OptionalLong.empty();
  private boolean onErrors;

  /** The lines of those that the debugger was told of last. */
  private Set<Integer> sent = Set.of();

  /** Where breakpoints are shown beside the text; it says which lines have one afterwards. */
  @FunctionalInterface
  public interface Marks {
    /** Sets or clears the mark of a line, counted from 1. */
    void toggle(ProgramDocument program, int line);
  }

  OpenBreakpoints(
      DebugLink link, Programs programs, StartedProgram started, Consumer<String> tell) {
    this.link = link;
    this.started = started;
    this.programs = programs;
    this.tell = tell;
    programs.addListener(this::tellListeners);
  }

  /** Has breakpoints set and cleared through the marks of an editor from now on. */
  public void setMarks(Marks marks) {
    this.marks = marks;
  }

  /** Has a program begin with the breakpoints that {@code known} has for it. */
  void setMemory(Function<ProgramDocument, List<Breakpoint>> known) {
    memory = known;
  }

  private void toggleHere(ProgramDocument program, int line) {
    SortedSet<Integer> lines = new TreeSet<>();
    list(program).all().forEach(each -> lines.add(each.line()));
    if (!lines.remove(line)) {
      lines.add(line);
    }
    linesChanged(program, lines);
  }

  private BreakpointList list(ProgramDocument program) {
    return lists.computeIfAbsent(
        program,
        each -> {
          BreakpointList list = new BreakpointList();
          memory.apply(each).forEach(list::set);
          return list;
        });
  }

  /** The script of the program in front, as it is now. */
  Source source() {
    return programs.current().script().source();
  }

  /** Those of the program in front, in the order of their lines. */
  public List<Breakpoint> all() {
    return list(programs.current()).all();
  }

  /** That of a line of the program in front. */
  Optional<Breakpoint> at(int line) {
    return list(programs.current()).at(line);
  }

  /** What became of one of the program in front, once the debugger knows it. */
  public Optional<BreakpointState> state(Breakpoint breakpoint) {
    return state(programs.current(), breakpoint);
  }

  /** What became of one of a program, once the debugger knows it. */
  Optional<BreakpointState> state(ProgramDocument program, Breakpoint breakpoint) {
    return started.is(program)
        ? states.stream().filter(each -> each.breakpoint().equals(breakpoint)).findFirst()
        : Optional.empty();
  }

  /** Those of a program, in the order of their lines. */
  public List<Breakpoint> all(ProgramDocument program) {
    return list(program).all();
  }

  /** Those of a program that would stop it, each on the line of the statement that it is before. */
  public List<Breakpoint> stopping(ProgramDocument program) {
    return all(program).stream()
        .filter(each -> each.enabled() && !each.logs())
        .map(
            each ->
                each.onLine(
                    state(program, each)
                        .map(BreakpointState::statementLine)
                        .filter(OptionalInt::isPresent)
                        .map(OptionalInt::getAsInt)
                        .orElse(each.line())))
        .map(each -> each.when(ByteText.asBytes(each.condition())))
        .toList();
  }

  /** The program that was started last; it may have been closed meanwhile. */
  public Optional<ProgramDocument> started() {
    return started.document();
  }

  /** The lines of {@code program} that have breakpoints have moved, each to another. */
  public void linesMoved(ProgramDocument program, SortedMap<Integer, Integer> moves) {
    list(program).move(moves);
    changed(program);
  }

  /** Lines of {@code program} that have breakpoints now, from 1. */
  public void linesChanged(ProgramDocument program, SortedSet<Integer> lines) {
    if (list(program).setLines(lines)) {
      changed(program);
    }
  }

  /** Sets or clears the breakpoint of a line of the program in front. */
  public void toggle(int line) {
    marks.toggle(programs.current(), line);
  }

  /** Sets a breakpoint of the program in front unless its line has one. */
  public void ensure(int line) {
    if (list(programs.current()).at(line).isEmpty()) {
      toggle(line);
    }
  }

  /** Changes a breakpoint of the program in front; it keeps its line. */
  public void change(Breakpoint breakpoint) {
    ProgramDocument program = programs.current();
    if (list(program).at(breakpoint.line()).filter(breakpoint::equals).isEmpty()) {
      list(program).set(breakpoint);
      changed(program);
    }
  }

  /** Clears the breakpoints of the program in front. */
  public void removeAll() {
    all().forEach(each -> toggle(each.line()));
  }

  /** Whether programs that fail are paused before they end. */
  public boolean onErrors() {
    return onErrors;
  }

  /** Has programs that fail paused before they end, or not. */
  public void setOnErrors(boolean wanted) {
    onErrors = wanted;
    link.ask(
        debugger -> {
          debugger.stopOnErrors(wanted);
          return wanted;
        },
        done -> tellListeners(),
        tell);
  }

  /**
   * A program is about to be started: its breakpoints take the place of all others. A command to
   * start it that is submitted afterwards finds them set.
   */
  public void beforeRun(ProgramDocument program) {
    beforeRun(program, RunScript.whole(program.script().source()));
  }

  /** As {@link #beforeRun(ProgramDocument)} for a text that may be a part of the program. */
  public void beforeRun(ProgramDocument program, RunScript script) {
    started.start(program, script);
    turns = OptionalLong.empty();
    send();
  }

  /**
   * How many turns the main program of a tree had begun when this was looked at last, see {@link
   * #lookAtTurns}; empty if it has none, or they cannot be counted.
   */
  public OptionalLong turns() {
    return turns;
  }

  /** Has the turns of the main program looked at; the answer comes a moment later. */
  public void lookAtTurns() {
    if (started.script().turnLine() > 0) {
      reload();
    }
  }

  /**
   * A program that is none of the user's has started: no breakpoint is meant for it but those in
   * its own text.
   *
   * @param received its text as it is shown, if it is
   */
  void strangerStarted(Optional<ProgramDocument> received) {
    started.startStranger(received);
    send();
    tellListeners();
  }

  private void changed(ProgramDocument program) {
    if (started.is(program)) {
      send();
    }
    tellListeners();
  }

  private void send() {
    List<Breakpoint> wanted = wanted();
    Set<Integer> before = sent;
    sent = wanted.stream().map(Breakpoint::line).collect(Collectors.toSet());
    boolean errors = onErrors;
    link.ask(
        debugger -> {
          if (!debugger.shared()) {
            debugger.stopOnErrors(errors);
          }
          for (BreakpointState each : debugger.breakpoints()) {
            // those of an editor that is attached are not ours
            boolean ours = !debugger.shared() || before.contains(each.breakpoint().line());
            if (ours && !wanted.contains(each.breakpoint())) {
              debugger.remove(each.breakpoint().line());
            }
          }
          List<Breakpoint> there =
              debugger.breakpoints().stream().map(BreakpointState::breakpoint).toList();
          wanted.stream().filter(each -> !there.contains(each)).forEach(debugger::set);
          return debugger.breakpoints();
        },
        this::show,
        tell);
  }

  private List<Breakpoint> wanted() {
    List<Breakpoint> wanted = new ArrayList<>();
    for (Breakpoint each :
        started.document().map(program -> list(program).all()).orElse(List.of())) {
      Breakpoint inBytes =
          each.when(ByteText.asBytes(each.condition())).logging(ByteText.asBytes(each.message()));
      started.toRun(each.line()).forEach(line -> wanted.add(inBytes.onLine(line)));
    }
    int turnLine = started.script().turnLine();
    if (turnLine > 0 && wanted.stream().noneMatch(each -> each.line() == turnLine)) {
      wanted.add(counter(turnLine));
    }
    return wanted;
  }

  /** One that counts and never stops anything. */
  private static Breakpoint counter(int line) {
    return Breakpoint.at(line).fromHit(Integer.MAX_VALUE);
  }

  /** Asks how often breakpoints were hit. */
  void reload() {
    link.ask(debugger -> debugger.breakpoints(), this::show, tell);
  }

  private void show(List<BreakpointState> found) {
    int turnLine = started.script().turnLine();
    turns = OptionalLong.empty();
    Map<Breakpoint, BreakpointState> shown = new LinkedHashMap<>();
    for (BreakpointState each : found) {
      if (turnLine > 0 && each.breakpoint().equals(counter(turnLine))) {
        turns = OptionalLong.of(started.script().turnsBefore() + each.hits());
        continue;
      }
      Breakpoint breakpoint =
          each.breakpoint()
              .onLine(started.toNow(each.breakpoint().line()))
              .when(ByteText.decoded(each.breakpoint().condition()))
              .logging(ByteText.decoded(each.breakpoint().message()));
      long before = shown.containsKey(breakpoint) ? shown.get(breakpoint).hits() : 0;
      shown.put(
          breakpoint,
          new BreakpointState(breakpoint, toNow(each.statementLine()), before + each.hits()));
    }
    List<BreakpointState> next = List.copyOf(shown.values());
    if (!next.equals(states)) {
      states = next;
      tellListeners();
    }
  }

  private OptionalInt toNow(OptionalInt line) {
    return line.isPresent() ? OptionalInt.of(started.toNow(line.getAsInt())) : line;
  }

  /** Tells {@code listener} when something has changed. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void tellListeners() {
    listeners.forEach(Runnable::run);
  }
}
