package org.pendant.command;

import java.util.List;
import java.util.stream.Stream;

/**
 * Training run: does in one process what the commands that should start fast do; the launcher has
 * the JVM note the classes that are loaded for it.
 */
public final class Training {
  private Training() {}

  /** Runs the programs that {@code words} name. */
  public static void main(String[] words) {
    System.exit(run(words).number());
  }

  static ExitCode run(String... programs) {
    List<String> words = Stream.concat(Stream.of("run"), Stream.of(programs)).toList();
    return new Pendant(Console.ofProcess()).run(words);
  }
}
