package org.pendant.editors.dap;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Typed assignment: what a user types to change a variable.
 *
 * @param target a variable or a part of one
 * @param value an expression
 */
record TypedAssignment(String target, String value) {
  private static final Pattern FORM =
      Pattern.compile(
          "\\s*(?:global\\s+)?([A-Za-z_]\\w*(?:\\.\\w+|\\[[^=\\[\\]]*])*)\\s*=(?!=)\\s*(.+)",
          Pattern.DOTALL);

  /** Reads one; empty for what is none. */
  static Optional<TypedAssignment> of(String text) {
    Matcher form = FORM.matcher(text);
    return form.matches()
        ? Optional.of(new TypedAssignment(form.group(1), form.group(2).strip()))
        : Optional.empty();
  }
}
