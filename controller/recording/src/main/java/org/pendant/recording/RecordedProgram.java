package org.pendant.recording;

import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.models.time.FrameTime;
import org.pendant.script.vm.ProgramEvent;

/**
 * Recorded program: the text of a program that ran, as it was then: the file may have changed
 * since.
 *
 * @param frame in which it started
 * @param name on its {@code def} line, as in {@link
 *     org.pendant.controller.state.ProgramStatus#name}
 * @param source its text, with the name of the file it came from
 */
public record RecordedProgram(long frame, String name, Source source) {
  /** Robot time at which it started, s. */
  public double timeS() {
    return frame / (double) FrameTime.FRAMES_PER_SECOND;
  }

  /**
   * The text of the program that has started in a frame, if one has.
   *
   * @param source the text of the running or last program, asked in that case only, such as {@code
   *     controller::programSource}
   */
  public static Optional<RecordedProgram> startedIn(
      ControllerState state, Supplier<Optional<Source>> source) {
    for (ProgramEvent each : state.newProgramEvents()) {
      if (each instanceof ProgramEvent.Started) {
        return source
            .get()
            .map(text -> new RecordedProgram(state.frame(), state.program().name(), text));
      }
    }
    return Optional.empty();
  }

  boolean sameText(RecordedProgram other) {
    return source == other.source
        || (source.name().equals(other.source.name()) && source.text().equals(other.source.text()));
  }
}
