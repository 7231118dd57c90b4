package org.pendant.desktop.session;

import java.time.Instant;
import java.util.Optional;

/**
 * Owner: a process that files belong to. Systems use numbers again, small ones soon, so its start
 * belongs to it.
 *
 * @param startedMs when it was started, ms since 1970; 0 where the system does not tell
 */
record Owner(long process, long startedMs) {
  /** This process. */
  static Owner self() {
    return of(ProcessHandle.current());
  }

  private static Owner of(ProcessHandle handle) {
    return new Owner(
        handle.pid(), handle.info().startInstant().map(Instant::toEpochMilli).orElse(0L));
  }

  /** The reverse of {@link #toString}; empty for a text that is none. */
  static Optional<Owner> parse(String text) {
    return text.matches("\\d{1,18} \\d{1,18}")
        ? Optional.of(
            new Owner(
                Long.parseLong(text.substring(0, text.indexOf(' '))),
                Long.parseLong(text.substring(text.indexOf(' ') + 1))))
        : Optional.empty();
  }

  /** Whether the process is still there. */
  boolean alive() {
    return ProcessHandle.of(process)
        .filter(ProcessHandle::isAlive)
        .filter(handle -> of(handle).equals(this))
        .isPresent();
  }

  @Override
  public String toString() {
    return process + " " + startedMs;
  }
}
