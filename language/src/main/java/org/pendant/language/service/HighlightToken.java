package org.pendant.language.service;

/**
 * Highlight token: a stretch of text and how it is coloured; what lies between two of them is
 * plain.
 *
 * @param start offset of its first byte
 * @param end offset just past its last byte
 */
public record HighlightToken(Style style, int start, int end) {

  /** The classes that a theme gives colours to. */
  public enum Style {
    KEYWORD,
    /** A function, thread or secondary program of this text. */
    FUNCTION,
    /** A function or method of the catalogue. */
    BUILTIN,
    VARIABLE,
    /** A parameter, also as the name of an argument. */
    PARAMETER,
    MEMBER,
    NUMBER,
    STRING,
    COMMENT,
    /** A program label (manual 11). */
    LABEL,
    OPERATOR,
    /** A name that nothing defines, or a sign without meaning. */
    UNKNOWN
  }
}
