package org.pendant.command;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Product JVM: a JVM that tests start, by what it is for. Under Maven each kind has an AOT cache,
 * which halves the time that a start takes, of just those classes that it loads; other runners have
 * none, since nothing there keeps them up to date.
 */
public enum ProductJvm {
  /** {@code ./pendant} without a window. */
  COMMAND("command.aot"),
  /** The desktop. */
  WINDOW("window.aot");

  private static final String NATIVE_ACCESS = "--enable-native-access=ALL-UNNAMED";

  private final String fileName;

  ProductJvm(String fileName) {
    this.fileName = fileName;
  }

  /** The class path of these tests, of nothing but startable jars where there is an AOT cache. */
  public String classPath() {
    return trained().isEmpty() ? testClassPath() : startableJars();
  }

  /** Options: an AOT cache serves only a JVM with the access that it was made with. */
  public List<String> options() {
    return Stream.concat(
            Stream.of(NATIVE_ACCESS), trained().stream().map(file -> "-XX:AOTCache=" + file))
        .toList();
  }

  /** Options that leave an AOT cache behind, to be used with {@link #options()}. */
  public List<String> trainingOptions() {
    return List.of(NATIVE_ACCESS, "-XX:AOTCacheOutput=" + cache());
  }

  /** Where its AOT cache is to be, in the folder that the build names. */
  public Path cache() {
    return Path.of(System.getProperty("pendant.aot")).resolve(fileName);
  }

  /**
   * Whether its AOT cache is younger than all jars of the class path; the JVM refuses it otherwise.
   */
  public boolean isFresh() {
    return Files.exists(cache()) && jars().stream().allMatch(jar -> age(jar) <= age(cache()));
  }

  /** The class path of startable jars, copies in {@link #folder}; see {@link #copyJars}. */
  public static String startableJars() {
    return copies().stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
  }

  /** Copies all jars into {@link #folder}, where they can be made startable. */
  public static void copyJars() throws IOException {
    Files.createDirectories(folder());
    List<Path> jars = jars();
    List<Path> copies = copies();
    for (int i = 0; i < jars.size(); i++) {
      Files.copy(jars.get(i), copies.get(i), StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /** Where startable jars lie. */
  public static Path folder() {
    return Path.of(System.getProperty("pendant.aot")).resolve("startable");
  }

  /** The copies, numbered since two jars may have the same name. */
  private static List<Path> copies() {
    List<Path> jars = jars();
    return IntStream.range(0, jars.size())
        .mapToObj(i -> folder().resolve(i + "-" + jars.get(i).getFileName()))
        .toList();
  }

  /** The jars of the class path, which is all that an AOT cache takes, and that of the tests. */
  private static List<Path> jars() {
    return Stream.concat(
            Arrays.stream(testClassPath().split(File.pathSeparator))
                .filter(each -> each.endsWith(".jar")),
            Stream.of(System.getProperty("pendant.tests")))
        .map(Path::of)
        .toList();
  }

  private List<Path> trained() {
    return System.getProperty("pendant.aot") != null && isFresh() ? List.of(cache()) : List.of();
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
