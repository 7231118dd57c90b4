package org.pendant.testing;

import java.util.List;

/**
 * File warnings: what people should look at in a file of tests, which keeps none of them from
 * running.
 *
 * @param file its name as places have it
 * @param lines a line each, with the place in front
 */
public record FileWarnings(String file, List<String> lines) {
  public FileWarnings {
    lines = List.copyOf(lines);
  }
}
