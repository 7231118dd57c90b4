package org.pendant.fuzz;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.Optional;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.message.LogEntry;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.DiagnosticFormat;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.LoadResult;

/** Runs one program and tells a fault of ours from one of the program. */
final class Faults {
  private static final int FRAMES = 25;

  private Faults() {}

  /** What went wrong inside, if anything did; that a program fails is none. */
  static Optional<String> ofRun(Source source, Builtins<ControlBox> builtins) {
    Controller controller = new Controller(ControllerOptions.headless(), builtins);
    LoadResult loadResult = controller.load(source);
    if (loadResult.program().isEmpty()) {
      return loadResult.diagnostics().stream()
          .filter(Diagnostic::isError)
          .findFirst()
          .map(each -> "does not compile: " + DiagnosticFormat.format(source, each));
    }
    var _ = controller.submit(new ProgramCommand.StartProgram(loadResult.program().get()));
    for (int frame = 0; frame < FRAMES; frame++) {
      controller.advance();
    }
    return controller.logSince(0).stream()
        .map(LogEntry::text)
        .filter(line -> line.startsWith("internal error"))
        .findFirst();
  }

  static String trace(Throwable broken) {
    StringWriter trace = new StringWriter();
    broken.printStackTrace(new PrintWriter(trace));
    return trace.toString().lines().limit(12).reduce("", (all, line) -> all + "\n" + line);
  }

  /** A text that shows every byte of it that a terminal would not. */
  static String visible(String text) {
    StringBuilder visible = new StringBuilder();
    text.chars()
        .forEach(
            each -> {
              if (each != '\n' && (each < ' ' || each > '~')) {
                visible.append(String.format("\\x%02x", each));
              } else {
                visible.append((char) each);
              }
            });
    return visible.toString();
  }
}
