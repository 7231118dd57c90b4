import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Programs that make parts of packages. */
final class ExternalProgram {
  private ExternalProgram() {}

  /** Whether PATH has it. */
  static boolean isThere(String program) {
    return Stream.of(System.getenv("PATH").split(":"))
        .anyMatch(folder -> Files.isExecutable(Path.of(folder, program)));
  }

  /** Runs a command, which must succeed. */
  static void run(String... command) throws IOException, InterruptedException {
    run(Map.of(), ProcessBuilder.Redirect.INHERIT, command);
  }

  /** Runs a command, which must succeed, with its standard output in a file. */
  static void writing(Path output, List<String> command) throws IOException, InterruptedException {
    ProcessBuilder.Redirect file = ProcessBuilder.Redirect.to(output.toFile());
    run(Map.of(), file, command.toArray(String[]::new));
  }

  /** Runs a command, which must succeed, with more in its environment. */
  static void run(
      Map<String, String> environment, ProcessBuilder.Redirect output, String... command)
      throws IOException, InterruptedException {
    ProcessBuilder builder =
        new ProcessBuilder(command)
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .redirectOutput(output);
    builder.environment().putAll(environment);
    int code = builder.start().waitFor();
    if (code != 0) {
      throw new IOException(Arrays.toString(command) + " ended with " + code);
    }
  }
}
