package org.pendant.editors.dap.look;

import static org.pendant.editors.dap.look.LookTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.recording.Moment;
import org.pendant.recording.RecordedCondition;
import org.pendant.script.debug.Debugger;
import org.pendant.script.debug.Variables;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Past view: a moment of the recording of a program. Nothing of it can be changed, and only what
 * the recording has can be seen.
 *
 * @param state of the robot at that moment
 * @param threads as far as the recording has them
 */
public record PastView(Moment moment, ControllerState state, List<ThreadSnapshot> threads)
    implements StandingProgram {
  /** Copies the list. */
  public PastView {
    threads = List.copyOf(threads);
  }

  /**
   * What a recording has of a moment.
   *
   * @param source the text that ran
   */
  public static PastView of(Moment moment, ControllerState state, Source source) {
    List<ThreadSnapshot> threads = state.debug().threads();
    return new PastView(moment, state, threads.isEmpty() ? List.of(main(state, source)) : threads);
  }

  /** Of a moment at which no debugger stopped, the line of the main thread alone is known. */
  private static ThreadSnapshot main(ControllerState state, Source source) {
    int line = Math.clamp(state.program().line(), 1, source.lineCount());
    String text = source.lineText(line);
    int start = source.lineStart(line) + text.length() - text.stripLeading().length();
    SourceRange range = new SourceRange(start, source.lineStart(line) + text.length());
    String name = state.program().name();
    return new ThreadSnapshot(
        Debugger.MAIN,
        name,
        "",
        List.of(new ThreadSnapshot.Level(name, source.name(), line, range)));
  }

  @Override
  public CompletableFuture<List<Scope>> scopes(int thread, int depth) {
    List<Scope> all = new ArrayList<>();
    VariableSamples variables = state.variables();
    if (!variables.locals().isEmpty()) {
      all.add(new Scope(text("locals"), "locals", branch(variables.locals())));
    }
    all.add(new Scope(text("globals"), "", branch(variables.globals())));
    all.addAll(StandingProgram.ofRobot(state));
    return CompletableFuture.completedFuture(all);
  }

  private static Branch branch(List<VariableSample> samples) {
    return new Recorded(samples.stream().map(PastView::shown).toList(), false);
  }

  private static Shown shown(VariableSample sample) {
    boolean members = sample.parts(1).stream().noneMatch(part -> part.name().startsWith("["));
    Optional<Branch> parts =
        sample.kept() == 0
            ? Optional.empty()
            : Optional.of(
                new Recorded(
                    sample.parts(Branch.MOST).stream().map(PastView::shown).toList(), !members));
    return Shown.of(sample.variable(), parts);
  }

  @Override
  public CompletableFuture<Shown> evaluate(int thread, int depth, String expression) {
    String bytes = ByteText.asBytes(expression);
    return new RecordedCondition(bytes)
        .value(state.variables())
        .map(
            value ->
                CompletableFuture.completedFuture(
                    shown(
                        VariableSample.of(
                            bytes, bytes, Optional.of(value), Variables.childCount(value)))))
        .orElseGet(
            () ->
                CompletableFuture.failedFuture(
                    new IllegalArgumentException(text("notRecorded", expression))));
  }

  @Override
  public CompletableFuture<Shown> assign(int thread, int depth, String target, String value) {
    return CompletableFuture.failedFuture(new IllegalArgumentException(unchangeable()));
  }

  /** Why nothing can be changed. */
  public static String unchangeable() {
    return text("pastUnchangeable");
  }

  /** Parts of what was recorded. */
  private record Recorded(List<Shown> all, boolean indexed) implements Branch {
    @Override
    public int size() {
      return all.size();
    }

    @Override
    public CompletableFuture<List<Shown>> page(int start, int count) {
      return CompletableFuture.completedFuture(Branch.cut(all, start, count));
    }

    @Override
    public CompletableFuture<Shown> assign(String name, String value) {
      return CompletableFuture.failedFuture(new IllegalArgumentException(unchangeable()));
    }
  }
}
