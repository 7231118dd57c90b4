package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Locale;
import java.util.Optional;
import org.pendant.controller.Drive;
import org.pendant.controller.disk.FileDraft;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.disk.GrowingFile;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.Recorder;
import org.pendant.recording.RecordingWriter;

/**
 * Run record: the file that a run is recorded to, if one is wanted. Its name says what it is:
 * {@code .rec} a recording of everything, all others a table.
 *
 * <p>It has its name from the start and grows by whole blocks, so that it can be read whenever the
 * process is killed. One that replaces another grows beside that and takes its place in the end.
 * When it cannot be written any more it complains once, and the run continues.
 */
final class RunRecord implements FrameWatcher, AutoCloseable {
  private static final String RECORDING = ".rec";

  private final Optional<Output> output;
  private final Optional<FileDraft> draft;
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

  private record Everything(RecordingWriter writer, Drive drive) implements Output {
    @Override
    public void write(ControllerState state) throws IOException {
      writer.write(state);
      Optional<RecordedProgram> text = RecordedProgram.startedIn(state, drive::programSource);
      if (text.isPresent()) {
        writer.note(text.get());
      }
    }

    @Override
    public void close() throws IOException {
      writer.close();
    }
  }

  private RunRecord(Optional<Output> output, Optional<FileDraft> draft, Console console) {
    this.output = output;
    this.draft = draft;
    this.console = console;
  }

  /**
   * Opens the file.
   *
   * @param file empty for no record
   * @param columns variables that it has besides
   * @param drive of the robot that is recorded; no frame has gone by
   * @throws UsageException when it cannot be created
   */
  static RunRecord open(
      Optional<OutputFile> file, RecordColumns columns, Drive drive, Console console)
      throws UsageException {
    if (file.isEmpty()) {
      return new RunRecord(Optional.empty(), Optional.empty(), console);
    }
    OutputFile wanted = file.get();
    try {
      if (!wanted.replaces()) {
        Output output = begin(wanted, GrowingFile.create(wanted.path()), columns, drive);
        return new RunRecord(Optional.of(output), Optional.empty(), console);
      }
      FileDraft draft = FileDraft.replacing(wanted.path());
      try {
        Output output = begin(wanted, draft.out(), columns, drive);
        console.complain(text("replacedAtEnd", wanted.name(), draft.beside()));
        return new RunRecord(Optional.of(output), Optional.of(draft), console);
      } catch (IOException e) {
        draft.close();
        throw e;
      }
    } catch (IOException e) {
      throw new UsageException(text("cannotBeWritten", wanted.name(), FileTrouble.reason(e)));
    }
  }

  private static Output begin(OutputFile file, OutputStream out, RecordColumns columns, Drive drive)
      throws IOException {
    try {
      return file.path().toString().toLowerCase(Locale.ROOT).endsWith(RECORDING)
          ? new Everything(new RecordingWriter(out, drive.state()), drive)
          : new Table(Recorder.to(out, columns.variables()));
    } catch (IOException e) {
      out.close();
      throw e;
    }
  }

  @Override
  public boolean looks() {
    return output.isPresent() && !failed;
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
    return false;
  }

  /** Whether frames were lost. */
  boolean failed() {
    return failed;
  }

  private void fail(IOException cause) {
    if (!failed) {
      console.complain(
          text(
              draft.isPresent() ? "recordFailedFileStays" : "recordFailedAndEnds",
              FileTrouble.reason(cause)));
    }
    failed = true;
  }

  @Override
  public void close() {
    if (output.isEmpty()) {
      return;
    }
    try (Closeable _ = draft.isPresent() ? draft.get() : () -> {}) {
      output.get().close();
      if (draft.isPresent() && !failed) {
        draft.get().commit();
      }
    } catch (IOException e) {
      fail(e);
    }
  }
}
