package org.pendant.script.vm;

import java.util.List;
import org.pendant.language.source.SourceRange;

/**
 * Thread snapshot: where one script thread was at some moment.
 *
 * @param id its handle; 0 for the main thread
 * @param name of the function that it began with, the program's for the main thread
 * @param waitsFor the built-in function that it waits in, such as {@code sleep}, or {@code thread
 *     2}; empty when it waits for nothing
 * @param stack its calls, innermost first, never empty
 */
public record ThreadSnapshot(int id, String name, String waitsFor, List<Level> stack) {
  public ThreadSnapshot {
    stack = List.copyOf(stack);
  }

  /**
   * One call of a function.
   *
   * @param function its name, or the program's
   * @param source name of the text it stands in: the program's, or {@code interpreter}
   * @param line 1-based line that it has reached
   * @param range the statement that is next where a debugger has stopped, otherwise the expression
   *     or statement that is under way, in that text
   */
  public record Level(String function, String source, int line, SourceRange range) {}

  /** The line that the innermost function has reached. */
  public int line() {
    return stack.getFirst().line();
  }
}
