package org.pendant.desktop.testwriter;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;
import org.pendant.command.service.TestFinder;

/** Test file name: where a test is written, and what it calls the program from there. */
public final class TestFileName {
  private static final String SCRIPT = ".script";

  private TestFileName() {}

  /**
   * The first name beside a program that is free: {@code pick_test.script}, {@code
   * pick_2_test.script}.
   */
  public static Path free(Path program, Predicate<Path> exists) {
    String name = program.getFileName().toString();
    String word = name.contains(".") ? name.substring(0, name.lastIndexOf('.')) : name;
    Path file = program.resolveSibling(word + TestFinder.ENDING);
    for (int i = 2; exists.test(file); i++) {
      file = program.resolveSibling(word + "_" + i + TestFinder.ENDING);
    }
    return file;
  }

  /** The file that people mean: tests are found by the ends of their names. */
  public static Path named(Path file) {
    String name = file.getFileName().toString();
    return name.endsWith(TestFinder.ENDING)
        ? file
        : file.resolveSibling(
            (name.endsWith(SCRIPT) ? name.substring(0, name.length() - SCRIPT.length()) : name)
                + TestFinder.ENDING);
  }

  /** The name of a file without its ending, after which its test is called. */
  public static String word(Path test) {
    String name = test.getFileName().toString();
    return name.endsWith(TestFinder.ENDING)
        ? name.substring(0, name.length() - TestFinder.ENDING.length())
        : name;
  }

  /** The name of a program from the folder of a test on; empty where there is no way to it. */
  public static Optional<String> program(Path program, Path test) {
    Path from = test.toAbsolutePath().normalize().getParent();
    Path to = program.toAbsolutePath().normalize();
    if (from == null || !to.getRoot().equals(from.getRoot())) {
      return Optional.empty();
    }
    return Optional.of(from.relativize(to).toString().replace('\\', '/'));
  }
}
