package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.sweep.engine.EngineException;

/**
 * Spark submission: has {@code spark-submit} of the Spark that people have run the same command
 * with the jar for it, where the engine is found on the class path. Spark itself is neither here
 * nor in that jar.
 */
final class SparkSubmission {
  /** Where the launcher says that the jar is. */
  static final String JAR_VARIABLE = "PENDANT_SPARK_JAR";

  /** Tells a process that it was submitted: it ends when its standard input does. */
  private static final String SUBMITTED_VARIABLE = "PENDANT_SUBMITTED";

  private static final String BUILDING =
      "mvn -Pspark -pl gui/spark -am -Dmaven.test.skip=true process-classes";

  /** A sweep that is stopped writes its table once more. */
  private static final int PATIENCE_S = 150;

  private static final long LOOK_MS = 100;

  private final SparkOptions options;
  private final Path program;
  private final Path jar;

  /**
   * @param environment of this process
   * @throws UsageException if the jar that is named is not there
   * @throws EngineException if there is no Spark, or its jar was not built
   */
  SparkSubmission(SparkOptions options, Map<String, String> environment)
      throws UsageException, EngineException {
    this.options = options;
    program = program(environment);
    jar = jar(options.jar(), environment);
  }

  /** Whether this process was started by one. */
  static boolean submitted() {
    return System.getenv(SUBMITTED_VARIABLE) != null;
  }

  private static Path program(Map<String, String> environment) throws EngineException {
    String name = File.separatorChar == '\\' ? "spark-submit.cmd" : "spark-submit";
    String home = environment.getOrDefault("SPARK_HOME", "");
    if (!home.isEmpty()) {
      Path program = Path.of(home, "bin", name);
      if (!Files.isExecutable(program)) {
        throw new EngineException(text("sparkHomeWrong", home, name));
      }
      return program;
    }
    for (String each : environment.getOrDefault("PATH", "").split(File.pathSeparator, -1)) {
      Path program = Path.of(each, name);
      if (!each.isEmpty() && Files.isExecutable(program)) {
        return program;
      }
    }
    throw new EngineException(text("sparkMissing", name));
  }

  private static Path jar(Optional<String> given, Map<String, String> environment)
      throws UsageException, EngineException {
    if (given.isPresent()) {
      if (!Files.isRegularFile(Path.of(given.get()))) {
        throw new UsageException(text("noSparkJar", given.get()));
      }
      return Path.of(given.get());
    }
    String built = environment.getOrDefault(JAR_VARIABLE, "");
    if (built.isEmpty() || !Files.isRegularFile(Path.of(built))) {
      throw new EngineException(text("sparkJarNotBuilt", BUILDING));
    }
    return Path.of(built);
  }

  /** The command line that runs {@code pendant} with some words. */
  List<String> command(List<String> words) {
    List<String> line = new ArrayList<>(List.of(program.toString(), "--name", "pendant sweep"));
    options.master().ifPresent(each -> line.addAll(List.of("--master", each)));
    for (String each : options.settings()) {
      line.addAll(List.of("--conf", each));
    }
    line.addAll(List.of("--class", Pendant.class.getName(), jar.toString()));
    line.addAll(words);
    return line;
  }

  /** Runs it to its end; Ctrl-C ends it as it would end the command itself. */
  ExitCode run(List<String> words, Console console) throws EngineException {
    ProcessBuilder builder =
        new ProcessBuilder(command(words))
            .redirectOutput(ProcessBuilder.Redirect.INHERIT)
            .redirectError(ProcessBuilder.Redirect.INHERIT);
    // Spark runs on the Java that this runs on, and opens no port to others without need.
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    if (options.master().orElse("").startsWith("local")) {
      builder.environment().putIfAbsent("SPARK_LOCAL_IP", "127.0.0.1");
    }
    builder.environment().put(SUBMITTED_VARIABLE, "true");
    console.flush();
    try (Interruption interruption = Interruption.listen("theSweep", PATIENCE_S)) {
      interruption.hold();
      Process process = builder.start();
      while (process.isAlive() && !interruption.awaitRequest(LOOK_MS)) {
        // it runs
      }
      // also where a signal came to this process alone, and when this process is killed
      process.getOutputStream().close();
      int code = process.waitFor();
      if (interruption.requested()) {
        // a signal ends this process, whatever it answers
        return ExitCode.of(code).orElse(ExitCode.DONE);
      }
      return ExitCode.of(code).orElseThrow(() -> new EngineException(text("sparkEndedWith", code)));
    } catch (IOException e) {
      throw new EngineException(text("sparkCannotStart", e.getMessage()), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new EngineException(text("sweepInterrupted"), e);
    }
  }
}
