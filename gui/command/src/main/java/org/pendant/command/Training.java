package org.pendant.command;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.editors.dap.DebugAdapterConnection;
import org.pendant.editors.lsp.LanguageServerConnection;

/**
 * Training run: does in one process what the commands that should start fast do; the launcher has
 * the JVM note the classes that are loaded for it.
 */
public final class Training {
  private Training() {}

  /**
   * Runs the programs that {@code words} name, and has an editor ask about the first and debug it.
   */
  public static void main(String[] words) throws IOException, InterruptedException {
    Path program = Path.of(words[0]).toAbsolutePath();
    List<String> run = Stream.concat(Stream.of("run"), Arrays.stream(words)).toList();
    ExitCode code = new Pendant(Console.ofProcess()).run(run);
    TrainingEditor editor = new TrainingEditor();
    LanguageServerConnection.serve(
        "training",
        editor.questions(Files.readString(program)),
        OutputStream.nullOutputStream(),
        Throwable::printStackTrace,
        complaint -> {});
    DebugAdapterConnection.serve(
        new DebuggedPrograms(),
        Optional.empty(),
        editor.debugging(program),
        editor.answers(),
        Throwable::printStackTrace,
        complaint -> {});
    System.exit(code.number());
  }
}
