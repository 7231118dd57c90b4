package org.pendant.controller.external;

import java.util.Optional;

/**
 * Delimited messages: between a prefix and a suffix, either of which may be empty (manual 18.61).
 * What stands before a prefix is dropped; what follows a suffix stays for the next read.
 */
final class Delimited {
  private final String prefix;
  private final String suffix;

  Delimited(String prefix, String suffix) {
    this.prefix = prefix;
    this.suffix = suffix;
  }

  /**
   * What was found.
   *
   * @param valid whether it is a message; otherwise it was too long and has been dropped
   * @param text of the message, without prefix and suffix
   */
  record Found(boolean valid, String text) {}

  /** Takes the next message; empty as long as it is not complete. */
  Optional<Found> next(ReceivedBytes in) {
    int length = in.length();
    int place = in.indexOf(prefix, 0, length);
    if (place < 0) {
      // the end of it may be the beginning of the prefix
      in.skip(Math.max(0, length - prefix.length() + 1));
      return Optional.empty();
    }
    in.skip(place);
    int end = Math.min(length - place, SocketRead.LONGEST);
    return suffix.isEmpty() ? all(in, end) : upToSuffix(in, end);
  }

  private Optional<Found> all(ReceivedBytes in, int end) {
    if (end <= prefix.length()) {
      return Optional.empty();
    }
    return taken(in, end, end);
  }

  private Optional<Found> upToSuffix(ReceivedBytes in, int end) {
    int suffixAt = in.indexOf(suffix, prefix.length(), end);
    if (suffixAt >= 0) {
      return taken(in, suffixAt, suffixAt + suffix.length());
    }
    if (end < SocketRead.LONGEST) {
      return Optional.empty();
    }
    in.skip(SocketRead.LONGEST);
    return Optional.of(new Found(false, ""));
  }

  private Optional<Found> taken(ReceivedBytes in, int textEnd, int end) {
    String text = in.text(prefix.length(), textEnd);
    in.skip(end);
    return Optional.of(new Found(true, text));
  }
}
