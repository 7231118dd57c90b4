package org.pendant.recording.compare;

/** Malformed table: a file is no table of samples; the message begins with the place. */
public final class MalformedTable extends Exception {
  private static final long serialVersionUID = 1L;

  MalformedTable(String message) {
    super(message);
  }
}
