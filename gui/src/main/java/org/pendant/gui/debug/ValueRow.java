package org.pendant.gui.debug;

import java.util.Optional;
import org.pendant.controller.debug.Variable;
import org.pendant.controller.value.Kind;
import org.pendant.language.source.ByteText;

/** A line of a table of values. */
sealed interface ValueRow {

  /** Stands above a group of values. */
  record Heading(String title) implements ValueRow {}

  /**
   * A value.
   *
   * @param level 0 for those that are part of nothing
   * @param changed since the stop before
   */
  record Value(ValueKey key, Variable variable, int level, boolean unfolded, boolean changed)
      implements ValueRow {

    boolean hasParts() {
      return variable.children() > 0;
    }

    String name() {
      return ByteText.decoded(variable.name());
    }

    /** As people read it; strings are in quotes so that they can be told from others. */
    String text() {
      String text = ByteText.decoded(variable.text());
      return variable.kind().equals(Optional.of(Kind.STRING)) ? '"' + text + '"' : text;
    }

    /** Such as {@code list [3]}. */
    String kind() {
      String kind = variable.kind().map(Kind::text).orElse("");
      return variable.kind().equals(Optional.of(Kind.LIST))
          ? kind + " [" + variable.children() + "]"
          : kind;
    }
  }

  /** Parts that are not shown yet. */
  record More(ValueKey key, int level, int shown, int total) implements ValueRow {
    String text() {
      return shown + " of " + total + " shown \u2013 Enter shows more";
    }
  }

  /**
   * Why something failed.
   *
   * @param key of the value above it
   */
  record Problem(ValueKey key, int level, String text) implements ValueRow {}
}
