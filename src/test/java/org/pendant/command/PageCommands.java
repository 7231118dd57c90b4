package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Page commands: does what a reader does who types the commands of a page in one folder. The
 * commands of Pendant run in this process; as this one has another folder, files are named by their
 * whole paths and what is printed has these taken out again.
 */
final class PageCommands {
  private static final Pattern WORD = Pattern.compile("'([^']*)'|\"([^\"]*)\"|([^\\s'\"]+)");

  /** What a shell understands and this does not. */
  private static final Pattern SHELL = Pattern.compile("\\s+(?:[|<&]|>).*|<\\(.*");

  private static final Pattern REDIRECTED = Pattern.compile("(.*) > (\\S+)");

  /** Commands whose operands are names of files, also of such as are not there yet. */
  private static final Set<String> NAMING_FILES = Set.of("convert");

  /** What a command looks through when it is told nothing. */
  private static final Map<String, String> LOOKING_AROUND = Map.of("test", ".");

  private final Path folder;
  private int exitCode;

  PageCommands(Path folder) {
    this.folder = folder;
  }

  /**
   * Output of a command.
   *
   * @param output standard output
   * @param errors standard error
   */
  record Said(int exitCode, String output, String errors) {
    /** Its lines, those of standard error behind the others. */
    List<String> lines() {
      return (output + errors).lines().toList();
    }

    /** A terminal shows the two streams as they come, which is not known here. */
    boolean agrees(List<String> shown) {
      return ShownOutput.agrees(shown, lines())
          || ShownOutput.agrees(shown, (errors + output).lines().toList());
    }
  }

  /** Types the lines of a block with prompts, and compares what it shows. */
  void type(PageBlock block) throws IOException {
    List<String> lines = block.text().lines().toList();
    for (int i = 0; i < lines.size(); ) {
      assertTrue(lines.get(i).startsWith("$ "), () -> block.place() + ": begins without a prompt");
      String command = lines.get(i++).substring(2);
      List<String> shown = new ArrayList<>();
      while (i < lines.size() && !lines.get(i).startsWith("$ ")) {
        shown.add(lines.get(i++));
      }
      boolean asksForCode = i < lines.size() && lines.get(i).equals("$ echo $?");
      type(block.place() + ": " + command, command, shown, asksForCode);
    }
  }

  private void type(String place, String command, List<String> shown, boolean asksForCode)
      throws IOException {
    List<String> words = words(command);
    switch (words.getFirst()) {
      case "echo" -> assertEquals(List.of(String.valueOf(exitCode)), shown, place);
      case "cat" -> show(place, folder.resolve(words.get(1)), shown);
      case "pendant", "./pendant" -> {
        Matcher redirected = REDIRECTED.matcher(command);
        Said said = pendant(words.subList(1, words.size()));
        exitCode = said.exitCode();
        if (redirected.matches()) {
          Files.writeString(folder.resolve(redirected.group(2)), said.output());
        } else if (!shown.isEmpty() && !said.agrees(shown)) {
          assertEquals(String.join("\n", shown), String.join("\n", said.lines()), place);
        }
        if (shown.isEmpty() && !asksForCode) {
          assertEquals(0, exitCode, () -> place + ": " + said.lines());
        }
      }
      default ->
          fail(place + ": only commands of pendant, cat and echo $? are run; mark the block");
    }
  }

  /** A file that a page shows: one that is there, or that a reader has made by now. */
  private void show(String place, Path file, List<String> shown) throws IOException {
    String text = String.join("\n", shown) + "\n";
    if (Files.notExists(file)) {
      Files.writeString(file, text);
    }
    assertEquals(Files.readString(file), text, place);
  }

  /** Runs a command of Pendant in the folder. */
  Said pendant(List<String> words) {
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    Pendant pendant = new Pendant(new Console(output, errors));
    ExitCode code = pendant.run(named(pendant, words));
    return new Said(code.number(), withoutFolder(output), withoutFolder(errors));
  }

  private String withoutFolder(ByteArrayOutputStream bytes) {
    return bytes
        .toString(StandardCharsets.UTF_8)
        .replace(folder + "/./", "")
        .replace(folder + "/", "")
        .replace(folder.toString(), ".");
  }

  /** The words with whole paths in place of names in the folder. */
  private List<String> named(Pendant pendant, List<String> words) {
    List<String> named = new ArrayList<>();
    String command = words.isEmpty() ? "" : words.getFirst();
    List<Option> options = optionsOf(pendant, command);
    boolean file = false;
    boolean operand = false;
    for (String word : words) {
      boolean names = file || Files.exists(folder.resolve(word)) && !word.equals(command);
      boolean isOperand = !word.startsWith("-") && !word.equals(command);
      operand |= isOperand;
      names |= isOperand && NAMING_FILES.contains(command);
      named.add(names ? folder.resolve(word).toString() : word);
      file =
          options.stream()
              .anyMatch(each -> each.name().equals(word) && each.role() != Option.Role.NO_FILE);
    }
    if (!operand && LOOKING_AROUND.containsKey(command)) {
      named.add(folder.resolve(LOOKING_AROUND.get(command)).toString());
    }
    return named;
  }

  private static List<Option> optionsOf(Pendant pendant, String command) {
    return pendant.subcommands().stream()
        .filter(each -> each.name().equals(command))
        .findFirst()
        .map(Subcommand::options)
        .orElse(List.of());
  }

  /** Whether the commands of Pendant in a block that does not run are there, with such options. */
  void read(PageBlock block) {
    boolean prompted = block.language().equals("console");
    for (String line : block.text().lines().toList()) {
      if (prompted && !line.startsWith("$ ")) {
        continue;
      }
      List<String> words = words(prompted ? line.substring(2) : line);
      if (words.size() > 1 && Set.of("pendant", "./pendant").contains(words.getFirst())) {
        read(block.place() + ": " + line, words.subList(1, words.size()));
      }
    }
  }

  private void read(String place, List<String> words) {
    Pendant pendant =
        new Pendant(new Console(new ByteArrayOutputStream(), new ByteArrayOutputStream()));
    if (List.of("--version", "--help").contains(words.getFirst())) {
      return;
    }
    if (words.getFirst().startsWith("-") || Files.exists(folder.resolve(words.getFirst()))) {
      read(place, optionsOf(pendant, "open"), words);
      return;
    }
    assertTrue(
        pendant.subcommands().stream().anyMatch(each -> each.name().equals(words.getFirst())),
        place);
    read(place, optionsOf(pendant, words.getFirst()), words.subList(1, words.size()));
  }

  private static void read(String place, List<Option> options, List<String> words) {
    try {
      Arguments.parse(options, words);
    } catch (UsageException e) {
      fail(place + ": " + e.getMessage());
    }
  }

  /** The words of a line as a shell has them, without its comment and what goes elsewhere. */
  static List<String> words(String line) {
    String command = SHELL.matcher(line.replaceFirst("(^|\\s+)# .*", "")).replaceFirst("");
    List<String> words = new ArrayList<>();
    Matcher word = WORD.matcher(command);
    int end = -1;
    while (word.find()) {
      String text =
          word.group(1) != null
              ? word.group(1)
              : word.group(2) != null ? word.group(2) : word.group(3);
      // 'a'b is one word
      if (word.start() == end) {
        text = words.removeLast() + text;
      }
      words.add(text);
      end = word.end();
    }
    return words;
  }
}
