package org.pendant.language.service;

import java.util.List;

/**
 * Quick fix: a way to put a diagnostic right.
 *
 * @param title what it does, for a menu, e.g. {@code Replace by movej}
 * @param edits what to change; all of them together
 */
public record QuickFix(String title, List<TextEdit> edits) {
  public QuickFix {
    edits = List.copyOf(edits);
  }

  static QuickFix replace(String title, int start, int end, String text) {
    return new QuickFix(title, List.of(TextEdit.replace(start, end, text)));
  }

  static QuickFix insert(String title, int offset, String text) {
    return replace(title, offset, offset, text);
  }
}
