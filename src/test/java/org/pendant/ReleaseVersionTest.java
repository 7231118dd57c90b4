package org.pendant;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.pendant.command.Launcher;

/**
 * All that is released has one version, that of the root pom; {@code src/release/version} sets it.
 */
final class ReleaseVersionTest {
  private static final Path HOME = Launcher.home();
  private static final String VERSION = only("pom.xml", "(?m)^  <version>(.*)</version>$");
  private static final String NUMBER = VERSION.replace("-SNAPSHOT", "");

  private static List<String> all(String file, String pattern) {
    try {
      return Pattern.compile(pattern)
          .matcher(Files.readString(HOME.resolve(file)))
          .results()
          .map(each -> each.group(1))
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String only(String file, String pattern) {
    List<String> found = all(file, pattern);
    assertEquals(1, found.size(), file + ": " + pattern);
    return found.getFirst();
  }

  @Test
  void itIsASemanticVersionOrASnapshotOfOne() {
    assertTrue(VERSION.matches("(0|[1-9]\\d*)(\\.(0|[1-9]\\d*)){2}(-SNAPSHOT)?"), VERSION);
  }

  @Test
  void everyModuleHasIt() throws IOException {
    List<Path> poms;
    try (Stream<Path> files =
        Files.find(
            HOME,
            4,
            (file, _) -> file.endsWith("pom.xml") && !file.toString().contains("target"))) {
      poms = files.map(HOME::relativize).filter(each -> each.getNameCount() > 1).sorted().toList();
    }
    assertTrue(poms.contains(Path.of("controller/junit/pom.xml")), poms.toString());
    for (Path pom : poms) {
      String parent = "(?s)<parent>.*?<version>([^<]*)</version>.*?</parent>";
      assertEquals(VERSION, only(pom.toString(), parent), pom.toString());
    }
  }

  @Test
  void thePythonPackageHasItAsPythonWritesVersions() {
    assertEquals(
        VERSION.replace("-SNAPSHOT", ".dev0"),
        only("protocols/python/pyproject.toml", "(?m)^version = \"(.*)\"$"));
  }

  @Test
  void theExtensionForVsCodeHasItsNumberOfWhichThereAreNoSnapshots() {
    assertEquals(NUMBER, only("gui/vscode/package.json", "(?m)^  \"version\": \"(.*)\",$"));
    assertEquals(
        List.of(NUMBER, NUMBER),
        all(
            "gui/vscode/package-lock.json",
            "\"name\": \"pendant-urscript\",\\s*\"version\": \"(.*)\""));
  }

  @Test
  void pagesShowIt() {
    assertEquals(
        VERSION,
        only(
            "docs/junit.md",
            "<artifactId>pendant-testing</artifactId>\\s*<version>(.*)</version>"));
    assertEquals(VERSION, only("docs/learn/install.md", "(?m)^pendant (\\S+) \\(commit"));
    List<String> packages = all("docs/packages.md", "pendant[-_](\\d[\\d.]*)[-_]");
    assertFalse(packages.isEmpty());
    packages.forEach(each -> assertEquals(NUMBER, each));
  }

  @Test
  void aReleaseHasItsHeadingInTheChangelogBelowThatOfWhatComesNext() {
    List<String> headings = all("CHANGELOG.md", "(?m)^## \\[(.*?)\\]");

    assertEquals("Unreleased", headings.getFirst());
    assertEquals(!VERSION.endsWith("-SNAPSHOT"), headings.contains(VERSION), headings.toString());
  }
}
