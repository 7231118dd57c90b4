package org.pendant.language.service;

import org.pendant.language.source.Source;

/**
 * A text with a caret in it, written as {@code |} in the examples of these tests.
 *
 * @param text the text without the mark
 * @param caret the offset of the mark
 */
record Marked(String text, int caret) {

  static Marked of(String marked) {
    int caret = marked.indexOf('|');
    if (caret < 0 || marked.indexOf('|', caret + 1) >= 0) {
      throw new IllegalArgumentException("expected one caret in " + marked);
    }
    return new Marked(marked.substring(0, caret) + marked.substring(caret + 1), caret);
  }

  ScriptAnalysis analysis() {
    return analysis(text);
  }

  static ScriptAnalysis analysis(String text) {
    return ScriptAnalysis.of(Source.of("test.script", text), new EditorCatalogue());
  }
}
