package org.pendant.recording;

import java.util.List;
import java.util.Optional;

/**
 * Form of a value: how it stands in a file. Both directions are written by hand: a developer who
 * changes a recorded type meets an error of the compiler here, and raises the version of the file.
 */
abstract class Form<T> {
  /** Appends a value. */
  abstract void write(T value, ByteSink out);

  /**
   * Reads what {@link #write} has written.
   *
   * @throws MalformedBytes if that cannot have been written so
   * @throws IllegalArgumentException from a type that checks what it is made of
   */
  abstract T read(ByteSource in) throws MalformedBytes;

  /** Appends a value of a type that only its {@link SnapshotPart} knows. */
  @SuppressWarnings(
      "unchecked") // a part's getter and form are of the same type, see its constructor
  final void writeObject(Object value, ByteSink out) {
    write((T) value, out);
  }

  /** The form of a value that may be missing. */
  final Form<Optional<T>> optional() {
    Form<T> form = this;
    return new Form<>() {
      @Override
      void write(Optional<T> value, ByteSink out) {
        out.bool(value.isPresent());
        value.ifPresent(present -> form.write(present, out));
      }

      @Override
      Optional<T> read(ByteSource in) throws MalformedBytes {
        return in.bool() ? Optional.of(form.read(in)) : Optional.empty();
      }
    };
  }

  /** The form of a list. */
  final Form<List<T>> list() {
    return new ListForm<>(this);
  }
}
