package org.pendant.script.vm;

import java.util.List;
import org.pendant.language.source.SourceRange;

/**
 * Script failure: why a program stopped by itself: a runtime error with its place.
 *
 * @param code stable kebab-case identifier
 * @param message what, the value, what was expected
 * @param range the expression or statement that failed, in the program's source
 * @param line 1-based line of {@code range}
 * @param column 1-based column of {@code range}
 * @param stack where it was called from, innermost first; the first entry is the failing function
 */
public record ScriptFailure(
    String code, String message, SourceRange range, int line, int column, List<StackEntry> stack) {
  public ScriptFailure {
    stack = List.copyOf(stack);
  }

  /**
   * One function on the script's call stack.
   *
   * @param function its name, or the program's
   * @param line 1-based line that it had reached
   */
  public record StackEntry(String function, int line) {}
}
