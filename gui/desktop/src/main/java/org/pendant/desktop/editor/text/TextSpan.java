package org.pendant.desktop.editor.text;

/**
 * Text span: a stretch of an editor's text, counted in characters.
 *
 * @param start its first character, at least 0
 * @param end just past its last, at least {@code start}
 */
public record TextSpan(int start, int end) {
  public TextSpan {
    if (start < 0 || end < start) {
      throw new IllegalArgumentException("span " + start + ".." + end + " is not ordered");
    }
  }

  /** Whether {@code offset} lies in it or directly behind it. */
  public boolean touches(int offset) {
    return start <= offset && offset <= end;
  }
}
