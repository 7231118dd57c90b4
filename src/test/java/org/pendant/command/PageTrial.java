package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringWriter;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.pendant.command.PageBlock.Extent;
import org.pendant.command.PageCommands.Said;
import org.pendant.sweep.Sweep;
import org.pendant.sweep.plan.PlanException;
import org.tomlj.Toml;
import org.xml.sax.SAXException;

/**
 * Page trial: does with a page what a reader does, from its first block to its last, in one folder
 * that has the examples in it.
 */
final class PageTrial {
  /** Behind the name in a title: what the block has is added to the file. */
  private static final String ADDED = ", added";

  /** A page says what a program prints in a block with this title behind it. */
  private static final String OUTPUT = "Output";

  /** What no part of Pendant reads, so that only a mark of its block can say why it is there. */
  private static final Set<String> FOREIGN = Set.of("lua", "elisp", "groovy", "yaml");

  /** An object or a device, or what else a scene may have. */
  private static final Pattern PART = Pattern.compile("\\{\\s*\"type\"|\\{\"");

  private static final List<String> BRIEFLY = List.of("--arm", "ideal", "--timeout", "60");

  private final Path folder;
  private final PageCommands commands;
  private String printed = "";

  /**
   * @param folder an empty one
   * @param blocks those of the page; where they name examples, or files that examples have, they
   *     find them
   */
  PageTrial(Path folder, List<PageBlock> blocks) throws IOException {
    this.folder = folder;
    commands = new PageCommands(folder);
    if (blocks.stream().anyMatch(PageTrial::wantsExamples)) {
      Path examples = Launcher.home().resolve("examples");
      try (Stream<Path> files = Files.walk(examples)) {
        for (Path file : files.toList()) {
          Files.copy(
              file, folder.resolve("examples").resolve(examples.relativize(file).toString()));
        }
      }
    }
    Files.createDirectories(folder.resolve("examples/tests"));
    Files.createDirectories(folder.resolve("examples/sweeps"));
    Files.writeString(folder.resolve("nothing.script"), "def nothing():\nend\n");
  }

  private static boolean wantsExamples(PageBlock block) {
    boolean hasFiles = block.language().equals("json") || block.text().contains("@scene");
    return block.text().contains("examples/")
        || block.text().contains("stack_boxes")
        || block.title().isEmpty() && hasFiles;
  }

  void take(PageBlock block) throws IOException {
    Optional<Path> file =
        block.title().filter(title -> !title.equals(OUTPUT)).map(t -> save(block));
    switch (block.language()) {
      case "urscript" -> script(block, file);
      case "console" -> type(block);
      case "sh" -> commands.read(block);
      case "json" -> json(block, file);
      case "toml" -> plan(block, file);
      case "pendant", "urpx" -> check(block, saved(block, file, ".pendant"));
      case "pinst" -> installation(block, saved(block, file, ".pinst"));
      case "xml" -> xml(block);
      case "java" -> compile(block);
      case "csv" -> table(block);
      case "text" -> text(block);
      case "python" -> {
        // DocumentationTest reads all of them at once, PythonPackageTest runs those of
        // docs/python.md.
      }
      default -> {
        assertTrue(FOREIGN.contains(block.language()), () -> block.place() + ": which language?");
        assertEquals(Extent.NOT_RUN, block.mark().extent(), () -> block.place() + ": needs a mark");
      }
    }
  }

  private Path save(PageBlock block) {
    String title = block.title().orElseThrow();
    boolean added = title.endsWith(ADDED);
    Path file = folder.resolve(added ? title.substring(0, title.length() - ADDED.length()) : title);
    try {
      Files.createDirectories(file.getParent());
      if (added) {
        Files.writeString(file, "\n" + block.text(), StandardOpenOption.APPEND);
      } else {
        Files.writeString(file, block.text());
      }
      return file;
    } catch (IOException e) {
      return fail(block.place() + ": " + e);
    }
  }

  private Path saved(PageBlock block, Optional<Path> file, String ending) throws IOException {
    return file.isPresent()
        ? file.get()
        : Files.writeString(folder.resolve("examples/line" + block.line() + ending), block.text());
  }

  /** Files are checked, as commands of the page run them; other programs run at once. */
  private void script(PageBlock block, Optional<Path> file) throws IOException {
    boolean tests = file.isEmpty() && block.page().startsWith("docs/testing");
    Path script = tests ? test(block) : saved(block, file, ".script");
    if (file.isPresent() || tests || block.mark().extent() == Extent.CHECKED) {
      check(block, script);
    } else if (block.runs()) {
      List<String> words = new ArrayList<>(List.of("run"));
      words.addAll(BRIEFLY);
      words.add(folder.relativize(script).toString());
      Said said = done(block, words);
      printed = said.output();
    }
  }

  /** A file of tests with what a page shows of one. */
  private Path test(PageBlock block) throws IOException {
    String text = block.text();
    if (text.startsWith("thread ")) {
      text += "def test_beside_it():\nend\n";
    } else if (!text.contains("def test_")) {
      text = "def test_with_it():\n" + text + "end\n";
    }
    String name = "examples/tests/line" + block.line() + "_test.script";
    return Files.writeString(folder.resolve(name), text);
  }

  private void check(PageBlock block, Path file) {
    if (block.mark().extent() != Extent.NOT_RUN) {
      done(block, List.of("check", folder.relativize(file).toString()));
    }
  }

  private Said done(PageBlock block, List<String> words) {
    Said said = commands.pendant(words);
    assertEquals(0, said.exitCode(), () -> block.place() + ": " + String.join("\n", said.lines()));
    return said;
  }

  private void type(PageBlock block) throws IOException {
    if (block.runs()) {
      commands.type(block);
    } else {
      commands.read(block);
    }
  }

  private void json(PageBlock block, Optional<Path> file) throws IOException {
    if (!block.runs()) {
      return;
    }
    String text = block.text();
    if (text.contains("\"jsonrpc\"") || text.contains("\"programs\":")) {
      return;
    }
    if (text.contains("\"toolSpeedMPerS\"")) {
      String safety = folder.relativize(saved(block, file, ".json")).toString();
      done(block, List.of("run", "--safety", safety, "nothing.script"));
    } else if (PART.matcher(text).lookingAt()) {
      boolean lines = text.lines().allMatch(line -> line.startsWith("{"));
      List<String> objects = new ArrayList<>();
      for (String line : lines ? text.lines().toList() : List.of(text)) {
        objects.add(partOfCell(block, line));
      }
      assertTrue(objects.stream().allMatch(String::isEmpty), () -> block.place() + ": " + objects);
    } else {
      assertEquals("", cell(saved(block, file, ".scene.json")), block::place);
    }
  }

  /** What is wrong with an object or a device on a line of its own. */
  private String partOfCell(PageBlock block, String line) throws IOException {
    List<String> faults = new ArrayList<>();
    for (String key : List.of("objects", "devices", "")) {
      String whole = key.isEmpty() ? line : "{\"" + key + "\": [" + line + "]}";
      Path file = folder.resolve("examples/part" + block.line() + ".scene.json");
      String fault = cell(Files.writeString(file, whole));
      if (fault.isEmpty()) {
        return "";
      }
      faults.add(fault);
    }
    return String.join("\n", faults);
  }

  private String cell(Path file) throws IOException {
    String name = folder.relativize(file).toString();
    Said said =
        commands.pendant(
            Files.readString(file).contains("\"arms\"")
                ? List.of("check", name)
                : List.of("check", "--cell", name, "--arm", "ideal", "nothing.script"));
    return said.exitCode() == 0 ? "" : said.errors();
  }

  private void plan(PageBlock block, Optional<Path> file) throws IOException {
    try {
      Path plan = file.isPresent() ? file.get() : folder.resolve("examples/sweeps/a.toml");
      if (file.isEmpty()) {
        Files.writeString(plan, block.text());
      }
      if (block.runs()) {
        Sweep.read(plan);
      } else {
        assertEquals(List.of(), Toml.parse(block.text()).errors(), block::place);
      }
    } catch (PlanException e) {
      fail(block.place() + ": " + e.getMessage());
    }
  }

  private void installation(PageBlock block, Path file) {
    if (block.runs()) {
      String name = folder.relativize(file).toString();
      done(block, List.of("run", "--installation", name, "nothing.script"));
    }
  }

  private static void xml(PageBlock block) throws IOException {
    try {
      DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .parse(new ByteArrayInputStream(block.text().getBytes(StandardCharsets.UTF_8)));
    } catch (SAXException | ParserConfigurationException e) {
      fail(block.place() + ": " + e.getMessage());
    }
  }

  private static void table(PageBlock block) {
    List<String> lines = block.text().lines().toList();
    long commas = lines.getFirst().chars().filter(each -> each == ',').count();
    for (String line : lines) {
      assertEquals(commas, line.chars().filter(each -> each == ',').count(), block.place());
    }
  }

  private void text(PageBlock block) {
    if (block.title().equals(Optional.of(OUTPUT))) {
      assertEquals(block.text(), printed, block.place());
    }
    assertTrue(
        block
            .text()
            .lines()
            .noneMatch(line -> line.matches("(\\$ )?(\\./)?pendant( \\S+)+|def \\w+\\(.*")),
        () -> block.place() + ": is no mere text");
  }

  private static void compile(PageBlock block) {
    if (!block.runs()) {
      return;
    }
    String name = block.text().replaceAll("(?s).*?\\bclass (\\w+).*", "$1");
    JavaFileObject source =
        new SimpleJavaFileObject(
            URI.create("string:///" + name + ".java"), JavaFileObject.Kind.SOURCE) {
          @Override
          public CharSequence getCharContent(boolean ignoreEncodingErrors) {
            return block.text();
          }
        };
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter said = new StringWriter();
    List<String> options =
        List.of("-proc:none", "-implicit:none", "-Xlint:all,-path", "-Werror", "-d", discarded());
    assertTrue(
        compiler.getTask(said, null, null, options, null, List.of(source)).call(),
        () -> block.place() + ": " + said);
  }

  private static String discarded() {
    try {
      Path classes = Files.createTempDirectory("pendant-page");
      classes.toFile().deleteOnExit();
      return classes.toString();
    } catch (IOException e) {
      return fail(e);
    }
  }
}
