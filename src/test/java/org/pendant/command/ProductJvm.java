package org.pendant.command;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What the JVMs that tests start are started with. Under Maven they share an AOT cache, which
 * halves the time that a start takes; other runners have none, since nothing there keeps it up to
 * date.
 */
public final class ProductJvm {
  private ProductJvm() {}

  /** The class path of these tests, of nothing but jars where there is an AOT cache. */
  public static String classPath() {
    return cache().isEmpty() ? testClassPath() : jars(Path.of(System.getProperty("pendant.tests")));
  }

  /**
   * Options of all of them: an AOT cache serves only a JVM with the access that it was made with.
   */
  public static List<String> options() {
    return Stream.concat(
            Stream.of("--enable-native-access=ALL-UNNAMED"),
            cache().stream().map(file -> "-XX:AOTCache=" + file))
        .toList();
  }

  /**
   * The jars of the class path, which is all that an AOT cache takes, and that of the tests.
   *
   * @param tests jar of the test classes
   */
  public static String jars(Path tests) {
    return Stream.concat(
            Arrays.stream(testClassPath().split(File.pathSeparator))
                .filter(each -> each.endsWith(".jar")),
            Stream.of(tests.toString()))
        .collect(Collectors.joining(File.pathSeparator));
  }

  /**
   * Whether an AOT cache is younger than all jars of a class path; the JVM refuses it otherwise.
   */
  public static boolean isFresh(Path cache, String classPath) {
    return Files.exists(cache)
        && Arrays.stream(classPath.split(File.pathSeparator))
            .map(Path::of)
            .allMatch(jar -> age(jar) <= age(cache));
  }

  private static List<Path> cache() {
    String cache = System.getProperty("pendant.aot");
    String tests = System.getProperty("pendant.tests");
    return cache != null && tests != null && isFresh(Path.of(cache), jars(Path.of(tests)))
        ? List.of(Path.of(cache))
        : List.of();
  }

  private static String testClassPath() {
    return System.getProperty("java.class.path");
  }

  private static long age(Path file) {
    try {
      return Files.getLastModifiedTime(file).toMillis();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
