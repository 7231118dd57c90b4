package org.pendant.gui.command;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.pendant.controller.Controller;
import org.pendant.controller.recording.ProgramText;
import org.pendant.controller.recording.Recorder;
import org.pendant.controller.recording.RecordingWriter;
import org.pendant.controller.state.ControllerState;

/**
 * The file that a run is recorded to, if one is wanted; complains once when it cannot be written.
 * Its name says what it is: {@code .rec} a recording of everything, all others a table.
 */
final class RunRecord implements FrameWatcher, AutoCloseable {
  private static final String RECORDING = ".rec";

  private final Optional<Output> output;
  private final Console console;
  private boolean failed;

  /** A file of either kind. */
  private interface Output extends Closeable {
    void write(ControllerState state) throws IOException;
  }

  private record Table(Recorder recorder) implements Output {
    @Override
    public void write(ControllerState state) throws IOException {
      recorder.write(state);
    }

    @Override
    public void close() throws IOException {
      recorder.close();
    }
  }

  private record Everything(RecordingWriter writer, Controller controller) implements Output {
    @Override
    public void write(ControllerState state) throws IOException {
      writer.write(state);
      Optional<ProgramText> text = ProgramText.startedIn(state, controller::programSource);
      if (text.isPresent()) {
        writer.note(text.get());
      }
    }

    @Override
    public void close() throws IOException {
      writer.close();
    }
  }

  private RunRecord(Optional<Output> output, Console console) {
    this.output = output;
    this.console = console;
  }

  /**
   * Opens the file.
   *
   * @param name empty for no record
   * @param columns variables that it has besides
   * @param controller that is recorded; no frame has gone by
   * @throws UsageException when it cannot be created
   */
  static RunRecord open(
      Optional<String> name, RecordColumns columns, Controller controller, Console console)
      throws UsageException {
    if (name.isEmpty()) {
      return new RunRecord(Optional.empty(), console);
    }
    try {
      Path file = Path.of(name.get());
      Output output =
          name.get().toLowerCase(Locale.ROOT).endsWith(RECORDING)
              ? new Everything(RecordingWriter.toFile(file, controller.state()), controller)
              : new Table(Recorder.toFile(file, columns.variables()));
      return new RunRecord(Optional.of(output), console);
    } catch (IOException | InvalidPathException e) {
      throw new UsageException("--record " + name.get() + ": cannot be written, " + e.getMessage());
    }
  }

  /** Appends one frame. */
  @Override
  public void see(ControllerState state) {
    if (output.isEmpty() || failed) {
      return;
    }
    try {
      output.get().write(state);
    } catch (IOException e) {
      fail(e);
    }
  }

  @Override
  public boolean enough() {
    return failed;
  }

  /** Whether frames were lost. */
  boolean failed() {
    return failed;
  }

  private void fail(IOException cause) {
    if (!failed) {
      console.complain("pendant run: the record cannot be written: " + cause.getMessage());
    }
    failed = true;
  }

  @Override
  public void close() {
    if (output.isPresent()) {
      try {
        output.get().close();
      } catch (IOException e) {
        fail(e);
      }
    }
  }
}
