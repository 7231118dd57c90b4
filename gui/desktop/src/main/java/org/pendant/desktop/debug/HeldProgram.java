package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.desktop.editor.Execution;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.Debugger;
import org.pendant.script.debug.PauseReason;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Paused program: where it is paused, and which of its calls is looked at; lines are those of its
 * current text.
 */
final class HeldProgram {
  private final StartedProgram started;
  private DebugState debug = DebugState.FREE;
  private Optional<Scope> selected = Optional.empty();
  private IntFunction<String> places;

  HeldProgram(StartedProgram started) {
    this.started = started;
    places = line -> text("line", started.toNow(line));
  }

  /** Takes what a snapshot says. */
  void show(DebugState newest) {
    debug = newest;
  }

  DebugState debug() {
    return debug;
  }

  boolean held() {
    return debug.held();
  }

  List<ThreadSnapshot> threads() {
    return debug.threads();
  }

  /** Why it is paused; empty while it is not. */
  String stopText() {
    return debug.stop().map(this::stopText).orElse("");
  }

  /** Why it was paused at a stop. */
  String stopText(DebugState.Stop stop) {
    return StopText.of(stop, places);
  }

  /** Calls lines of the running text so in sentences, in place of by their present number. */
  void nameLinesBy(IntFunction<String> names) {
    places = names;
  }

  /** What a line of the running text is called in a sentence. */
  String place(int line) {
    return places.apply(line);
  }

  // --- the call that is looked at

  Optional<Scope> selected() {
    return selected;
  }

  void selectNothing() {
    selected = Optional.empty();
  }

  /** Looks at a call, 1 for the outermost; nothing happens if there is none. */
  Optional<Scope> select(int thread, int depth) {
    Optional<ThreadSnapshot> wanted = thread(thread);
    if (wanted.isEmpty() || depth < 1 || depth > wanted.get().stack().size()) {
      return Optional.empty();
    }
    selected = Optional.of(new Scope(thread, depth, level(wanted.get(), depth).function()));
    return selected;
  }

  /** Whether the call that is looked at has not returned. */
  boolean selectionExists() {
    return selected
        .filter(scope -> scope.depth() <= thread(scope.thread()).map(HeldProgram::calls).orElse(0))
        .isPresent();
  }

  /** How deep the innermost call of a thread is. */
  int depth(int thread) {
    return thread(thread).map(HeldProgram::calls).orElse(Debugger.OUTERMOST);
  }

  private Optional<ThreadSnapshot> thread(int id) {
    return debug.threads().stream().filter(each -> each.id() == id).findFirst();
  }

  private static int calls(ThreadSnapshot thread) {
    return thread.stack().size();
  }

  private static ThreadSnapshot.Level level(ThreadSnapshot thread, int depth) {
    return thread.stack().get(thread.stack().size() - depth);
  }

  /**
   * The line of the call that is looked at; 0 for none, and for lines of interpreter mode and of
   * programs that are not open.
   */
  int line() {
    return selected
        .filter(scope -> held() && !started.hidden())
        .flatMap(scope -> thread(scope.thread()).map(each -> level(each, scope.depth())))
        .filter(level -> !level.source().equals("interpreter"))
        .map(level -> started.toNow(level.line()))
        .orElse(0);
  }

  // --- what stands beside the text

  /** Where the program is, paused or not. */
  Execution execution(ControllerState state) {
    Optional<DebugState.Stop> stop = debug.stop().filter(each -> state.debug().held());
    if (stop.isEmpty()) {
      return failure(state.program())
          .orElseGet(() -> Execution.running(started.toNow(state.program().line())));
    }
    boolean there =
        selected
            .filter(scope -> scope.thread() == stop.get().thread())
            .filter(scope -> scope.depth() == depth(scope.thread()))
            .isPresent();
    boolean failed = there && stop.get().reason() instanceof PauseReason.Failed;
    return new Execution(
        line(),
        failed ? Execution.State.FAILED : Execution.State.HELD,
        there ? StopText.atLine(stop.get()) : "");
  }

  /** A program that has failed shows where until its text is another. */
  private Optional<Execution> failure(ProgramStatus program) {
    return program
        .ending()
        .filter(ending -> started.unchanged())
        .flatMap(
            ending ->
                ending instanceof Ending.Failed failed
                    ? Optional.of(
                        new Execution(
                            started.toNow(failed.failure().line()),
                            Execution.State.FAILED,
                            Messages.shown(ByteText.decoded(failed.failure().message()))))
                    : Optional.empty());
  }
}
