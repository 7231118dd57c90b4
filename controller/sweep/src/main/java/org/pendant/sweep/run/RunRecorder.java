package org.pendant.sweep.run;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Optional;
import org.pendant.controller.Drive;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.RecordingWriter;

/** Run recorder: writes a run of a sweep as a recording, which the window opens. For one run. */
public final class RunRecorder implements RunWatcher, Closeable {
  private final OutputStream out;
  private Optional<Begun> begun = Optional.empty();
  private Optional<IOException> failure = Optional.empty();

  private record Begun(RecordingWriter writer, Drive drive) {}

  /**
   * A recorder.
   *
   * @param out is closed with it
   */
  public RunRecorder(OutputStream out) {
    this.out = out;
  }

  @Override
  public void begin(Drive drive) {
    try {
      begun = Optional.of(new Begun(new RecordingWriter(out, drive.state()), drive));
    } catch (IOException e) {
      failure = Optional.of(e);
    }
  }

  @Override
  public void see(ControllerState state) {
    if (begun.isEmpty() || failure.isPresent()) {
      return;
    }
    try {
      begun.get().writer().write(state);
      Optional<RecordedProgram> program =
          RecordedProgram.startedIn(state, begun.get().drive()::programSource);
      if (program.isPresent()) {
        begun.get().writer().note(program.get());
      }
    } catch (IOException e) {
      failure = Optional.of(e);
    }
  }

  /** Whether the run came to be recorded: not where it was refused before its first frame. */
  public boolean recorded() {
    return begun.isPresent();
  }

  /**
   * Ends the recording.
   *
   * @throws IOException if it, or anything before, could not be written
   */
  @Override
  public void close() throws IOException {
    if (failure.isPresent()) {
      throw failure.get();
    }
    if (begun.isPresent()) {
      begun.get().writer().close();
    } else {
      out.close();
    }
  }
}
