package org.pendant.controller.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;

/** Error pauses: the errors on which a program wants to be paused (manual 15.40). */
final class ErrorPauses {
  /** Kinds of errors at most; the oldest one is forgotten, so that no program fills the memory. */
  private static final int MOST = 256;

  private final List<Wanted> wanted = new ArrayList<>();

  private record Wanted(int code, OptionalInt argument) {
    boolean fits(SafetyStop error) {
      return error.code() == code
          && (argument.isEmpty() || argument.getAsInt() == error.argument());
    }
  }

  void add(int code, OptionalInt argument) {
    Wanted next = new Wanted(code, argument);
    if (!wanted.contains(next)) {
      if (wanted.size() == MOST) {
        wanted.removeFirst();
      }
      wanted.add(next);
    }
  }

  void clear() {
    wanted.clear();
  }

  boolean contains(SafetyStop error) {
    return wanted.stream().anyMatch(each -> each.fits(error));
  }
}
