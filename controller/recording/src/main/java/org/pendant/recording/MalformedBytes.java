package org.pendant.recording;

/** Bytes of a recording that cannot have been written by this version. */
final class MalformedBytes extends Exception {
  private static final long serialVersionUID = 1L;

  MalformedBytes(String message) {
    super(message);
  }
}
