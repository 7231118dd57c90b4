package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** Every block of every page does what the page says, in the order of the page. */
@Tag("slow")
final class DocumentationTest {
  private static final Path HOME = Launcher.home();

  private static final String READ_PYTHON =
      "import sys\n"
          + "for i in range(1, len(sys.argv), 2): compile(sys.argv[i + 1], sys.argv[i], 'exec')";

  @TempDir private Path folder;

  private static List<Path> pages() throws IOException {
    try (Stream<Path> docs = Files.walk(HOME.resolve("docs"))) {
      return Stream.concat(
              Stream.of("README.md", "CONTRIBUTING.md").map(HOME::resolve),
              docs.filter(file -> file.toString().endsWith(".md")).sorted())
          .toList();
    }
  }

  @TestFactory
  Stream<DynamicTest> blocksDoWhatThePageSays() throws IOException {
    List<DynamicTest> tests = new ArrayList<>();
    for (Path page : pages()) {
      List<PageBlock> blocks = PageBlock.of(HOME, page);
      String number = String.valueOf(tests.size());
      if (!blocks.isEmpty()) {
        tests.add(dynamicTest(HOME.relativize(page).toString(), () -> follow(blocks, number)));
      }
    }
    return tests.stream();
  }

  private void follow(List<PageBlock> blocks, String number) throws IOException {
    PageTrial trial =
        new PageTrial(Files.createDirectory(folder.resolve(number)).toRealPath(), blocks);
    List<String> faults = new ArrayList<>();
    for (PageBlock block : blocks) {
      try {
        trial.take(block);
      } catch (AssertionError e) {
        faults.add(e.getMessage());
      }
    }
    assertEquals("", String.join("\n\n", faults));
  }

  /** A change of this list shows what is no longer tried, and why. */
  @Test
  void blocksThatAreNotRunSayWhy() throws IOException {
    List<String> found = new ArrayList<>();
    for (PageBlock block : blocks()) {
      if (!block.runs()) {
        String extent = block.mark().extent() == PageBlock.Extent.CHECKED ? "checked" : "not run";
        found.add(
            block.page() + ", " + block.language() + ", " + extent + ": " + block.mark().reason());
      }
    }
    Path list = HOME.resolve("src/test/resources/org/pendant/command/blocks-not-run.txt");
    assertEquals(Files.readString(list), String.join("\n", found) + "\n", found.size() + " blocks");
  }

  @Test
  void blocksInPythonAreRead() throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of("python3", "-c", READ_PYTHON));
    for (PageBlock block : blocks()) {
      if (block.language().equals("python")) {
        command.add(block.place());
        command.add(block.text());
      }
    }
    Process process;
    try {
      process = new ProcessBuilder(command).redirectErrorStream(true).start();
    } catch (IOException e) {
      Assumptions.abort("skipped: Python 3 is missing");
      return;
    }
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), said);
  }

  private static List<PageBlock> blocks() throws IOException {
    List<PageBlock> blocks = new ArrayList<>();
    for (Path page : pages()) {
      blocks.addAll(PageBlock.of(HOME, page));
    }
    return blocks;
  }
}
