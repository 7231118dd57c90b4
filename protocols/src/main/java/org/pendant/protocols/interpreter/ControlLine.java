package org.pendant.protocols.interpreter;

import java.util.Locale;
import java.util.Optional;

/** Control line: what a line can ask for that is no statement (manual 13.5 to 13.7). */
enum ControlLine {
  ABORT,
  SKIPBUFFER,
  STATELASTEXECUTED,
  STATELASTINTERPRETED,
  STATELASTCLEARED,
  STATEUNEXECUTED;

  /** The word as it is sent. */
  String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Whether it changes nothing. */
  boolean asks() {
    return this != ABORT && this != SKIPBUFFER;
  }

  /** What {@code line} asks for; empty for statements. */
  static Optional<ControlLine> of(String line) {
    String word = line.strip();
    for (ControlLine each : values()) {
      if (each.word().equals(word)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }
}
