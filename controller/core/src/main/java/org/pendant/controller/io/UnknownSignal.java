package org.pendant.controller.io;

import java.io.Serial;

/** There is no signal of the name that somebody wrote. */
public final class UnknownSignal extends IllegalArgumentException {
  @Serial private static final long serialVersionUID = 1L;

  UnknownSignal(String message) {
    super(message);
  }
}
