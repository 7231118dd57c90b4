package org.pendant.recording;

import java.util.ArrayList;
import java.util.List;

/** Program texts of a recording, by the frames of their starts. Immutable. */
record ProgramTexts(List<RecordedProgram> all, long bytes) {
  static final ProgramTexts NONE = new ProgramTexts(List.of(), 0);

  /** Starts that are known; of more the oldest are forgotten. */
  static final int MOST = 1000;

  private static final int BYTES_EACH = 100;

  ProgramTexts {
    all = List.copyOf(all);
  }

  /** With one more, which shares the text of the one before if it is the same. */
  ProgramTexts with(RecordedProgram added) {
    if (all.size() == MOST) {
      return from(all.get(1).frame()).with(added);
    }
    List<RecordedProgram> more = new ArrayList<>(all);
    long length = BYTES_EACH;
    if (!all.isEmpty() && added.sameText(all.getLast())) {
      more.add(new RecordedProgram(added.frame(), added.name(), all.getLast().source()));
    } else {
      more.add(added);
      length += added.source().text().length();
    }
    return new ProgramTexts(more, bytes + length);
  }

  /** Those that had started up to the end of a frame. */
  ProgramTexts until(long frame) {
    ProgramTexts left = NONE;
    for (RecordedProgram each : all) {
      if (each.frame() <= frame) {
        left = left.with(each);
      }
    }
    return left;
  }

  /** Without those that had ended before frame {@code frame}: another one had started. */
  ProgramTexts from(long frame) {
    int first = 0;
    while (first + 1 < all.size() && all.get(first + 1).frame() <= frame) {
      first++;
    }
    if (first == 0) {
      return this;
    }
    ProgramTexts left = NONE;
    for (RecordedProgram each : all.subList(first, all.size())) {
      left = left.with(each);
    }
    return left;
  }
}
