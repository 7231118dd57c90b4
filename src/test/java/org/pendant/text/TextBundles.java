package org.pendant.text;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Properties;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The texts of all modules as they are in the sources, by package. */
final class TextBundles {
  private static final Path ROOT = Path.of("..", "..").toAbsolutePath().normalize();

  /** How the names of bundles begin that the servers of editors speak. */
  static final String OF_EDITORS = "editors.";

  private static final Pattern PLACE = Pattern.compile("\\{\\d\\*?}|%(\\d\\$)?[-,.\\d]*[sdfeg%n]");

  private static final Pattern SPEAKS_ENGLISH = Pattern.compile("\\bTexts\\.english\\(");

  private TextBundles() {}

  /** The file of the English texts of each package that has some. */
  static List<Path> english() throws IOException {
    try (Stream<Path> files = Files.find(ROOT, 7, (file, attributes) -> isEnglish(file))) {
      return files.sorted().toList();
    }
  }

  private static boolean isEnglish(Path file) {
    Path folder = file.getParent();
    return folder.endsWith(Path.of("src", "main", "resources", "texts"))
        && file.toString().endsWith(".properties")
        && !file.getFileName().toString().contains("_");
  }

  /** The texts of a file by key. */
  static TreeMap<String, String> read(Path file) throws IOException {
    Properties texts = new Properties();
    try (Reader reader = Files.newBufferedReader(file)) {
      texts.load(reader);
    }
    TreeMap<String, String> byKey = new TreeMap<>();
    texts.forEach((key, text) -> byKey.put((String) key, (String) text));
    return byKey;
  }

  /** The same texts in another language. */
  static Path in(Language language, Path english) {
    String name = english.getFileName().toString();
    return english.resolveSibling(
        name.replace(".properties", "_" + language.code() + ".properties"));
  }

  /** Name of the package without {@code org.pendant}, by which the bundle is found. */
  static String name(Path english) {
    return english.getFileName().toString().replace(".properties", "");
  }

  /** Whether it belongs to a package that speaks English, and is translated where it is shown. */
  static boolean isTranslatedWhereShown(Path english) throws IOException {
    for (Path source : sources(english)) {
      if (SPEAKS_ENGLISH.matcher(Files.readString(source)).find()) {
        return true;
      }
    }
    return false;
  }

  /**
   * Names of the bundles that are translated by where something is shown, as their list has them.
   */
  static List<String> translatedWhereShown() throws IOException {
    Path list = ROOT.resolve("gui/editors/src/main/resources/texts/bundles.txt");
    try (Stream<String> lines = Files.lines(list)) {
      return lines.filter(line -> !line.startsWith("#")).toList();
    }
  }

  /** A text with values of which each is known again. */
  static String withValues(String text) {
    String filled = text;
    for (int i = 0; i < 10; i++) {
      String value = "<" + i + ">";
      filled = filled.replace("{" + i + "}", value).replace("{" + i + "*}", value);
    }
    return filled;
  }

  /** The sources of the package that says the texts of a file, all or a part of what it says. */
  static List<Path> sources(Path english) throws IOException {
    String name = name(english);
    Path main = english.getParent().getParent().resolveSibling("java");
    Path folder = main.resolve(Path.of("org", "pendant")).resolve(name.replace('.', '/'));
    Path whole = Files.isDirectory(folder) ? folder : folder.getParent();
    try (Stream<Path> files = Files.list(whole)) {
      return files.filter(each -> each.toString().endsWith(".java")).sorted().toList();
    }
  }

  /** The sources under a folder of the project. */
  static List<Path> sourcesUnder(String folder) throws IOException {
    try (Stream<Path> files = Files.walk(ROOT.resolve(folder))) {
      return files.filter(each -> each.toString().endsWith(".java")).sorted().toList();
    }
  }

  /**
   * Places for values in a text, such as <code>{0}</code> and {@code %,d}, in no order; those of a
   * translation that take a text, <code>{0*}</code>, are places like others.
   */
  static TreeSet<String> places(String text) {
    return PLACE
        .matcher(text)
        .results()
        .map(each -> each.group().replaceFirst("\\d\\$", "").replace("*}", "}"))
        .collect(Collectors.toCollection(TreeSet::new));
  }
}
