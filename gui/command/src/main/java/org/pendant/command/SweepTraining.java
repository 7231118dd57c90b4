package org.pendant.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * Sweep training: runs small sweeps; the launcher has the JVM note the classes that are loaded for
 * them, and which methods the optimizing compiler was needed for.
 */
public final class SweepTraining {
  private static final String PLAN =
      """
      program = "program.script"
      time_limit = 60
      [[parameter]]
      set = "slider"
      from = 0.7
      to = 1
      steps = 4
      """;

  private SweepTraining() {}

  /** Runs some variants of each of the programs that {@code words} name. */
  public static void main(String[] words) throws IOException {
    Path folder = Files.createTempDirectory("pendant-training");
    ExitCode code;
    try {
      code = run(folder, words);
    } finally {
      delete(folder);
    }
    System.exit(code.number());
  }

  /** Each program has its plan and its results in a folder of its own in {@code folder}. */
  static ExitCode run(Path folder, String... programs) throws IOException {
    ExitCode code = ExitCode.DONE;
    for (int i = 0; i < programs.length && code == ExitCode.DONE; i++) {
      Path own = Files.createDirectory(folder.resolve("" + i));
      Files.copy(Path.of(programs[i]), own.resolve("program.script"));
      Path plan = Files.writeString(own.resolve("plan.toml"), PLAN);
      code = new Pendant(Console.ofProcess()).run(List.of("sweep", plan.toString()));
    }
    return code;
  }

  private static void delete(Path folder) throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.walk(folder)) {
      files = all.toList().reversed();
    }
    for (Path file : files) {
      Files.delete(file);
    }
  }
}
