package org.pendant.testing;

import java.util.List;

/**
 * Broken test file: a file of which no test could run.
 *
 * @param file its name
 * @param problems each as {@code file:line:column: error: text}, as {@code pendant check} says it
 */
public record BrokenTestFile(String file, List<String> problems) {
  public BrokenTestFile {
    problems = List.copyOf(problems);
  }
}
