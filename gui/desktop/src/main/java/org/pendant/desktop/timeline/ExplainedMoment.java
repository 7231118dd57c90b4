package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.Recording;
import org.pendant.recording.explain.MotionExplanation;

/**
 * Explained moment: why the arm moved as it did at the moment that people look at. The frames
 * around it may be in a file, so they are read outside of the dispatch thread, which alone calls
 * this; until they are there the explanation before is shown.
 */
public final class ExplainedMoment {
  private final LookBack lookBack;
  private final Explainer explainer;
  private final Consumer<String> tell;
  private final RecordingReader<MotionExplanation> reader;
  private Optional<ControllerState> wanted = Optional.empty();
  private Optional<MotionExplanation> explained = Optional.empty();

  /** Explains a frame. */
  public interface Explainer {
    /**
     * Explains a frame. Any thread may call it.
     *
     * @param ofFile whether the recording is of a file
     */
    MotionExplanation explain(Recording recording, long frame, boolean ofFile);
  }

  /**
   * Explains nothing yet.
   *
   * @param tell hears what went wrong
   */
  public ExplainedMoment(LookBack lookBack, Explainer explainer, Consumer<String> tell) {
    this(lookBack, explainer, tell, RecordingReader.ofWindow("explanation"));
  }

  /** As the other one, with a reader. */
  ExplainedMoment(
      LookBack lookBack,
      Explainer explainer,
      Consumer<String> tell,
      RecordingReader<MotionExplanation> reader) {
    this.lookBack = lookBack;
    this.explainer = explainer;
    this.tell = tell;
    this.reader = reader;
  }

  /** The moment that people look at, explained, or the one before; empty for now. */
  public Optional<MotionExplanation> explanation() {
    Optional<ControllerState> at = lookBack.past();
    if (!at.equals(wanted)) {
      wanted = at;
      if (at.isPresent()) {
        read(at.get());
      } else {
        reader.forget();
        explained = Optional.empty();
      }
    }
    return explained;
  }

  private void read(ControllerState at) {
    Recording recording = lookBack.recording();
    boolean ofFile = lookBack.ofFile();
    reader.read(
        () -> explainer.explain(recording, at.frame(), ofFile),
        explanation -> {
          // nothing is explained any more to who is back from the past
          if (wanted.isPresent()) {
            explained = Optional.of(explanation);
          }
        },
        why -> tell.accept(text("thatMomentCannotBeExplained", why)));
  }
}
