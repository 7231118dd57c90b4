package org.pendant.command;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.pendant.editors.dap.DebugAdapterConnection;
import org.pendant.editors.lsp.LanguageServerConnection;

/**
 * Editor training: answers an editor that asks about a program and debugs it; the launcher has the
 * JVM note the classes that are loaded for it.
 */
public final class EditorTraining {
  private EditorTraining() {}

  /** Runs the first of the programs that {@code words} name, and has an editor look at it. */
  public static void main(String[] words) throws IOException, InterruptedException {
    Path program = Path.of(words[0]).toAbsolutePath();
    ExitCode code = Training.run(words[0]);
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
