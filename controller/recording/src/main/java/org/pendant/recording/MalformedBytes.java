package org.pendant.recording;

/** Malformed bytes of a recording, which cannot have been written by this version. */
final class MalformedBytes extends Exception {
  private static final long serialVersionUID = 1L;

  MalformedBytes(String message) {
    super(message);
  }
}
