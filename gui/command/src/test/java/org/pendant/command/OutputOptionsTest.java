package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.models.arm.ArmLibrary;

/**
 * Whatever option writes a file, of whatever command: it refuses what the command reads. The lists
 * of options say what there is to be tried, so that a new one is tried as well.
 */
final class OutputOptionsTest {
  private static final String PROGRAM = "program.script";

  /** A file that each option for reading takes; a new one needs a line here. */
  private static final Map<String, String> SAMPLES =
      Map.of(
          "--robot", armFile(),
          "--installation", "pendant installation 1\n",
          "--calibration",
              """
              delta_theta = [0,0,0,0,0,0]
              delta_a = [0,0,0,0,0,0]
              delta_d = [0,0,0,0,0,0]
              delta_alpha = [0,0,0,0,0,0]
              """,
          "--waveforms", "time,signal,value\n",
          "--scene", "{}",
          "--cell", "{}",
          "--safety", "{}",
          "--collection", "# a run\na.csv a.script\n");

  /** What the program comes after. */
  private static final Map<String, List<String>> OPERANDS = Map.of("compare", List.of("run.csv"));

  private static final Map<String, String> ENDINGS =
      Map.of("--installation", ".pinst", "--calibration", ".conf");

  @TempDir private Path folder;

  private static String armFile() {
    try (InputStream file = ArmLibrary.class.getResourceAsStream("ur5e.json")) {
      return new String(file.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static List<Subcommand> subcommands() {
    return new Pendant(new Console(new ByteArrayOutputStream(), new ByteArrayOutputStream()))
        .subcommands();
  }

  private static List<Option> options(Subcommand subcommand, Option.Role role) {
    return subcommand.options().stream().filter(each -> each.role() == role).toList();
  }

  static Stream<Arguments> commandsThatWrite() {
    return subcommands().stream()
        .filter(OutputOptionsTest::reads)
        .flatMap(
            subcommand ->
                options(subcommand, Option.Role.WRITTEN).stream()
                    .map(option -> arguments(subcommand.name(), option.name())));
  }

  private static boolean reads(Subcommand subcommand) {
    return !subcommand.operands().isEmpty() || !options(subcommand, Option.Role.READ).isEmpty();
  }

  private static Subcommand subcommand(String name) {
    return subcommands().stream()
        .filter(each -> each.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void everyOptionThatNamesAFileSaysWhetherItIsReadOrWritten() {
    for (Subcommand each : subcommands()) {
      for (Option option : options(each, Option.Role.NO_FILE)) {
        assertTrue(!option.value().contains("FILE"), each.name() + " " + option.usage());
      }
    }
  }

  @Test
  void everyCommandThatWritesCanBeForced() {
    for (Subcommand each : subcommands()) {
      if (!options(each, Option.Role.WRITTEN).isEmpty()) {
        assertTrue(each.options().contains(OutputFile.FORCE), each.name());
      }
    }
  }

  @ParameterizedTest
  @MethodSource("commandsThatWrite")
  void outputIsNoneOfTheInputs(String command, String output) throws IOException {
    boolean takesProgram = !subcommand(command).operands().isEmpty();
    Map<String, String> inputs =
        new TreeMap<>(takesProgram ? Map.of("", "def f():\nend\n") : Map.of());
    for (Option each : options(subcommand(command), Option.Role.READ)) {
      assertTrue(SAMPLES.containsKey(each.name()), "a sample for " + each.name());
      inputs.put(each.name(), SAMPLES.get(each.name()));
    }
    Path program = folder.resolve(PROGRAM);
    for (Map.Entry<String, String> input : inputs.entrySet()) {
      boolean isProgram = input.getKey().isEmpty();
      Path file =
          isProgram
              ? program
              : folder.resolve("input" + ENDINGS.getOrDefault(input.getKey(), ".json"));
      Files.writeString(file, input.getValue());
      List<String> words = new ArrayList<>(List.of(command, output, file.toString()));
      if (!isProgram) {
        words.addAll(List.of(input.getKey(), file.toString()));
      }
      words.addAll(OPERANDS.getOrDefault(command, List.of()));
      if (takesProgram) {
        Files.writeString(program, inputs.get(""));
        words.add(program.toString());
      }
      assertRefused(words);
      words.add(OutputFile.FORCE.name());
      assertRefused(words);
      assertEquals(input.getValue(), Files.readString(file), words.toString());
    }
  }

  private static void assertRefused(List<String> words) {
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    ExitCode code = new Pendant(new Console(said, errors)).run(words);

    String complaint = errors.toString(StandardCharsets.UTF_8);
    assertEquals(ExitCode.WRONG_USAGE, code, complaint);
    assertTrue(complaint.contains("which this command reads and never overwrites"), complaint);
    assertEquals("", said.toString(StandardCharsets.UTF_8));
  }
}
