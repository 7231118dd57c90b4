package org.pendant.command;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import org.pendant.controller.Drive;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.RecordingWriter;
import org.pendant.testing.run.TestObserver;

/** Test recorder: writes the frames of a test down. What cannot be written is thrown unchecked. */
final class TestRecorder implements TestObserver, Closeable {
  private final OutputStream out;
  private Drive drive;
  private RecordingWriter writer;

  /**
   * A recorder of one run.
   *
   * @param out is closed with it
   */
  TestRecorder(OutputStream out) {
    this.out = out;
  }

  @Override
  public void begins(Drive of) {
    drive = of;
    try {
      writer = new RecordingWriter(out, of.state());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void sees(ControllerState state) {
    try {
      writer.write(state);
      var text = RecordedProgram.startedIn(state, drive::programSource);
      if (text.isPresent()) {
        writer.note(text.get());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    if (writer != null) {
      writer.close();
    }
  }
}
