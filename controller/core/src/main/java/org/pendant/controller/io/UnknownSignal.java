package org.pendant.controller.io;

import java.io.Serial;

/** Refusal of a name that no signal has. */
public final class UnknownSignal extends IllegalArgumentException {
  @Serial private static final long serialVersionUID = 1L;

  UnknownSignal(String message) {
    super(message);
  }
}
