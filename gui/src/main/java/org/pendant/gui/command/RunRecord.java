package org.pendant.gui.command;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import org.pendant.controller.recording.Recorder;
import org.pendant.controller.state.ControllerState;

/**
 * The file that a run is recorded to, if one is wanted; complains once when it cannot be written.
 */
final class RunRecord implements FrameWatcher, AutoCloseable {
  private final Optional<Recorder> recorder;
  private final Console console;
  private boolean failed;

  private RunRecord(Optional<Recorder> recorder, Console console) {
    this.recorder = recorder;
    this.console = console;
  }

  /**
   * Opens the file.
   *
   * @param name empty for no record
   * @param columns variables that it has besides
   * @throws UsageException when it cannot be created
   */
  static RunRecord open(Optional<String> name, RecordColumns columns, Console console)
      throws UsageException {
    if (name.isEmpty()) {
      return new RunRecord(Optional.empty(), console);
    }
    try {
      return new RunRecord(
          Optional.of(Recorder.toFile(Path.of(name.get()), columns.variables())), console);
    } catch (IOException | InvalidPathException e) {
      throw new UsageException("--record " + name.get() + ": cannot be written, " + e.getMessage());
    }
  }

  /** Appends the row of one frame. */
  @Override
  public void see(ControllerState state) {
    if (recorder.isEmpty() || failed) {
      return;
    }
    try {
      recorder.get().write(state);
    } catch (IOException e) {
      fail(e);
    }
  }

  @Override
  public boolean enough() {
    return failed;
  }

  /** Whether rows were lost. */
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
    if (recorder.isPresent()) {
      try {
        recorder.get().close();
      } catch (IOException e) {
        fail(e);
      }
    }
  }
}
