package org.pendant.language.service;

import org.pendant.language.source.SourceRange;

/** Occurrence: one place where a name stands, what it means there, and what happens to it. */
public record Occurrence(Symbol symbol, SourceRange range, Role role) {

  /** What a program does with a name. */
  public enum Role {
    /** A definition's head, or a parameter in it. */
    DECLARE,
    /** The target of an assignment. */
    WRITE,
    /** Any other use, calls and changes of elements included. */
    USE
  }
}
