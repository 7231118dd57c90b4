package org.pendant.language.service;

/**
 * Folding range: lines that can be folded away after the first of them.
 *
 * @param startLine the line that stays, 1-based
 * @param endLine the last line that goes, after {@code startLine}
 */
public record FoldingRange(Kind kind, int startLine, int endLine) {

  /** What is folded. */
  public enum Kind {
    BLOCK,
    COMMENT
  }
}
