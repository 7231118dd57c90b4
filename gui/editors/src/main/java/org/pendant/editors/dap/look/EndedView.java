package org.pendant.editors.dap.look;

import static org.pendant.editors.dap.look.LookTexts.text;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.recording.Moment;
import org.pendant.recording.RecordedStep;
import org.pendant.recording.Recording;
import org.pendant.recording.StepSearch;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Ended view: a program that has ended, as it was then. It stands where its last statement was.
 *
 * @param end what is known of the end
 */
public record EndedView(PastView end) implements StandingProgram {
  /**
   * The end of a run.
   *
   * @param now what the robot published last
   * @param source the text that ran
   */
  public static EndedView of(Recording recording, ControllerState now, Source source) {
    List<ThreadSnapshot> last =
        new StepSearch(recording)
            .before(Moment.endOf(now.frame() + 1))
            .map(RecordedStep::moment)
            .map(moment -> PastView.of(moment, recording.at(moment), source).threads())
            .orElseGet(() -> PastView.of(Moment.of(now), now, source).threads());
    return new EndedView(new PastView(Moment.of(now), now, last.subList(0, 1)));
  }

  @Override
  public List<ThreadSnapshot> threads() {
    return end.threads();
  }

  @Override
  public ControllerState state() {
    return end.state();
  }

  @Override
  public CompletableFuture<List<Scope>> scopes(int thread, int depth) {
    return end.scopes(thread, depth);
  }

  @Override
  public CompletableFuture<Shown> evaluate(int thread, int depth, String expression) {
    return end.evaluate(thread, depth, expression);
  }

  @Override
  public CompletableFuture<Shown> assign(int thread, int depth, String target, String value) {
    return CompletableFuture.failedFuture(new IllegalArgumentException(text("endUnchangeable")));
  }
}
