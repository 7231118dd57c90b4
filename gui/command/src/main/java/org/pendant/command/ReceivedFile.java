package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.controller.disk.FileDraft;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.disk.GrowingFile;
import org.pendant.models.arm.ArmDescription;
import org.pendant.protocols.rtde.ReceivedField;
import org.pendant.recording.ReceivedRecording;

/** Received file: what a controller sends by RTDE, as a table or a {@code .rec}. */
final class ReceivedFile implements Closeable {
  private final OutputFile file;
  private final Optional<FileDraft> draft;
  private final Form form;
  private boolean whole;

  /** How rows are written. */
  private interface Form extends Closeable {
    void write(ByteBuffer data) throws IOException;

    /** Whether there is nothing that makes a file. */
    boolean isEmpty();

    /** What has been written may be found from now on. */
    void flush() throws IOException;
  }

  private ReceivedFile(OutputFile file, Optional<FileDraft> draft, Form form) {
    this.file = file;
    this.draft = draft;
    this.form = form;
  }

  /**
   * Begins a table.
   *
   * @param separator between its cells
   * @throws UsageException when it cannot be written
   */
  static ReceivedFile table(OutputFile file, List<ReceivedField> fields, char separator)
      throws UsageException {
    return begin(file, out -> new Table(out, fields, separator));
  }

  /**
   * Begins a {@code .rec}.
   *
   * @param arm that the controller has
   * @throws UsageException when it cannot be written
   */
  static ReceivedFile recording(OutputFile file, List<ReceivedField> fields, ArmDescription arm)
      throws UsageException {
    return begin(file, out -> new Snapshots(out, fields, arm));
  }

  private interface Beginning {
    Form in(OutputStream out) throws IOException;
  }

  private static ReceivedFile begin(OutputFile file, Beginning beginning) throws UsageException {
    try {
      Optional<FileDraft> draft =
          file.replaces() ? Optional.of(FileDraft.replacing(file.path())) : Optional.empty();
      OutputStream out = draft.isPresent() ? draft.get().out() : GrowingFile.create(file.path());
      return new ReceivedFile(file, draft, beginning.in(out));
    } catch (IOException e) {
      throw unwritable(file, e);
    }
  }

  private static UsageException unwritable(OutputFile file, IOException e) {
    return new UsageException(text("cannotBeWritten", file.name(), FileTrouble.reason(e)));
  }

  /** Its name, without its folder. */
  String shortName() {
    return file.path().getFileName().toString();
  }

  /**
   * Takes a row.
   *
   * @param data with the values of all fields; its position stays
   * @throws UsageException when it cannot be written
   */
  void write(ByteBuffer data) throws UsageException {
    try {
      form.write(data.duplicate());
    } catch (IOException e) {
      throw unwritable(file, e);
    }
  }

  /**
   * Hands over what has been written.
   *
   * @throws UsageException when it cannot be written
   */
  void flush() throws UsageException {
    try {
      form.flush();
    } catch (IOException e) {
      throw unwritable(file, e);
    }
  }

  /**
   * Ends it: from now on it has its name. A {@code .rec} without a row is none.
   *
   * @throws UsageException when it cannot be written
   */
  void end() throws UsageException {
    try {
      form.close();
      if (draft.isPresent() && !form.isEmpty()) {
        draft.get().commit();
      }
      whole = true;
    } catch (IOException e) {
      throw unwritable(file, e);
    }
  }

  /** What has not been {@link #end ended} is given up as far as it does not have its name yet. */
  @Override
  public void close() throws IOException {
    try (Closeable _ = draft.isPresent() ? draft.get() : () -> {}) {
      if (!whole) {
        form.close();
      }
    }
  }

  /** Rows of a table, with the names of the fields above. */
  private static final class Table implements Form {
    private final List<ReceivedField> fields;
    private final char separator;
    private final Writer table;
    private final StringBuilder row = new StringBuilder();

    Table(OutputStream out, List<ReceivedField> fields, char separator) throws IOException {
      this.fields = fields;
      this.separator = separator;
      table = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.US_ASCII));
      table.write(
          fields.stream()
              .flatMap(each -> each.columns().stream())
              .collect(Collectors.joining(String.valueOf(separator), "", "\n")));
      table.flush();
    }

    @Override
    public void write(ByteBuffer data) throws IOException {
      row.setLength(0);
      for (ReceivedField each : fields) {
        if (!row.isEmpty()) {
          row.append(separator);
        }
        each.append(data, separator, row);
      }
      table.append(row.append('\n'));
    }

    @Override
    public boolean isEmpty() {
      return false;
    }

    @Override
    public void flush() throws IOException {
      table.flush();
    }

    @Override
    public void close() throws IOException {
      table.close();
    }
  }

  /** Snapshots of a {@code .rec}. */
  private static final class Snapshots implements Form {
    private final List<ReceivedField> fields;
    private final double[] row;
    private final ReceivedRecording recording;
    private boolean empty = true;

    Snapshots(OutputStream out, List<ReceivedField> fields, ArmDescription arm) {
      this.fields = fields;
      row = new double[fields.stream().mapToInt(ReceivedField::count).sum()];
      recording =
          new ReceivedRecording(
              out, arm, fields.stream().flatMap(each -> each.columns().stream()).toList());
    }

    @Override
    public void write(ByteBuffer data) throws IOException {
      int at = 0;
      for (ReceivedField each : fields) {
        each.read(data, row, at);
        at += each.count();
      }
      // a package that repeats the time of the one before adds nothing
      empty &= !recording.write(row);
    }

    @Override
    public boolean isEmpty() {
      return empty;
    }

    /** It is handed over by whole blocks. */
    @Override
    public void flush() {}

    @Override
    public void close() throws IOException {
      recording.close();
    }
  }
}
