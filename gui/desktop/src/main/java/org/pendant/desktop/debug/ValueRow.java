package org.pendant.desktop.debug;

import java.util.List;
import java.util.Optional;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.Variable;
import org.pendant.script.value.ValueKind;

/** Value row: a line of a table of values. */
sealed interface ValueRow {

  /** Whether a value is marked as changed, and since when. */
  enum Change {
    NONE,
    SINCE_STOP,
    JUST_NOW
  }

  /**
   * Whether both have the same lines in the same order, so that only the values in them may differ.
   */
  static boolean sameLines(List<ValueRow> some, List<ValueRow> others) {
    if (some.size() != others.size()) {
      return false;
    }
    for (int i = 0; i < some.size(); i++) {
      boolean same = sameLine(some.get(i), others.get(i));
      if (!same) {
        return false;
      }
    }
    return true;
  }

  private static boolean sameLine(ValueRow some, ValueRow other) {
    return some instanceof Value one
        ? other instanceof Value two && one.key().equals(two.key()) && one.level() == two.level()
        : some.equals(other);
  }

  /** Stands above a group of values. */
  record Heading(String title) implements ValueRow {}

  /**
   * A value.
   *
   * @param level 0 for those that are part of nothing
   * @param favourite whether it comes first
   */
  record Value(
      ValueKey key,
      Variable variable,
      int level,
      boolean unfolded,
      Change change,
      boolean favourite)
      implements ValueRow {

    boolean changed() {
      return change != Change.NONE;
    }

    boolean hasParts() {
      return variable.children() > 0;
    }

    String name() {
      return ByteText.decoded(variable.name());
    }

    /** As people read it; strings are in quotes so that they can be told from others. */
    String text() {
      String text = ByteText.decoded(variable.text());
      return variable.kind().equals(Optional.of(ValueKind.STRING)) ? '"' + text + '"' : text;
    }

    /** Such as {@code list [3]}. */
    String kind() {
      String kind = variable.kind().map(ValueKind::text).orElse("");
      return variable.kind().equals(Optional.of(ValueKind.LIST))
          ? kind + " [" + variable.children() + "]"
          : kind;
    }
  }

  /**
   * Parts that are not shown yet.
   *
   * @param cut whether the others are not known while the program runs
   */
  record More(ValueKey key, int level, int shown, int total, boolean cut) implements ValueRow {
    String text() {
      return DebugTexts.text(cut ? "shownUntilPaused" : "shownUntilEnter", shown, total);
    }
  }

  /**
   * Why something failed.
   *
   * @param key of the value above it
   */
  record Problem(ValueKey key, int level, String text) implements ValueRow {}
}
