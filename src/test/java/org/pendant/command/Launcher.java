package org.pendant.command;

import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/** Starts {@code ./pendant} on the classes under test. */
public final class Launcher {
  /** Far longer than anything here takes; a process that is still there then hangs. */
  private static final int PATIENCE_S = 60;

  /**
   * What stands before the command. A build in the background of a shell ignores SIGINT, and what
   * it starts does so too unless a caller says otherwise, which neither a shell nor Java can.
   */
  private static final List<String> LISTENING_TO_INTERRUPTS = listeningToInterrupts();

  private Launcher() {}

  private static List<String> listeningToInterrupts() {
    List<String> prefix = List.of("env", "--default-signal=INT");
    List<String> probe = new ArrayList<>(prefix);
    probe.add("true");
    try {
      Process process =
          new ProcessBuilder(probe)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      // Other systems than Linux have an env without this option.
      return await(process) == 0 ? prefix : List.of();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * What a process did.
   *
   * @param output standard output, one {@code char} a byte
   * @param errors standard error
   */
  record Result(int exitCode, String output, String errors) {
    List<String> outputLines() {
      return output.lines().toList();
    }
  }

  /** The project's folder. */
  public static Path home() {
    // Maven sets it; other test runners start in the project's folder.
    return Path.of(System.getProperty("pendant.home", ".")).toAbsolutePath().normalize();
  }

  /** Runs {@code ./pendant words} in {@code folder} to its end. */
  static Result pendant(Path folder, String... words) {
    return run(folder, commandLine(words));
  }

  /** Runs {@code line} with a shell in which {@code $PENDANT} is the launcher. */
  static Result shell(Path folder, String line) {
    return run(folder, List.of("sh", "-c", line));
  }

  private static Result run(Path folder, List<String> command) {
    Process process = start(folder, command);
    CompletableFuture<byte[]> output =
        CompletableFuture.supplyAsync(() -> all(process.getInputStream()));
    CompletableFuture<byte[]> errors =
        CompletableFuture.supplyAsync(() -> all(process.getErrorStream()));
    int exitCode = await(process);
    return new Result(
        exitCode,
        new String(output.join(), StandardCharsets.ISO_8859_1),
        new String(errors.join(), StandardCharsets.UTF_8));
  }

  /** Starts {@code ./pendant words}; its standard error goes where that of the tests goes. */
  static Process start(Path folder, String... words) {
    return start(folder, commandLine(words));
  }

  private static Process start(Path folder, List<String> command) {
    try {
      Process process = prepare(folder, command).start();
      process.getOutputStream().close();
      return process;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Describes how {@code ./pendant words} is started in {@code folder}. */
  public static ProcessBuilder prepare(Path folder, String... words) {
    return prepare(folder, commandLine(words));
  }

  private static List<String> commandLine(String... words) {
    List<String> command = new ArrayList<>(LISTENING_TO_INTERRUPTS);
    command.add(home().resolve("pendant").toString());
    command.addAll(List.of(words));
    return command;
  }

  private static ProcessBuilder prepare(Path folder, List<String> command) {
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().put("PENDANT", home().resolve("pendant").toString());
    builder.environment().put("PENDANT_JAVA_HOME", System.getProperty("java.home"));
    builder.environment().put("PENDANT_CLASSPATH", ProductJvm.COMMAND.classPath());
    builder
        .environment()
        .put("PENDANT_JAVA_OPTIONS", String.join(" ", ProductJvm.COMMAND.options()));
    return builder;
  }

  /** Waits for the end of {@code process} and answers its exit code. */
  public static int await(Process process) {
    try {
      if (!process.waitFor(PATIENCE_S, TimeUnit.SECONDS)) {
        process.destroyForcibly();
        return fail("still running after " + PATIENCE_S + " s: " + process.info().commandLine());
      }
      return process.exitValue();
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
      return fail("interrupted");
    }
  }

  private static byte[] all(InputStream stream) {
    try (stream) {
      return stream.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Writes a script into {@code folder}; {@code text} has one {@code char} a byte. */
  static String script(Path folder, String name, String text) {
    try {
      Files.write(folder.resolve(name), text.getBytes(StandardCharsets.ISO_8859_1));
      return name;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
