package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.DiagnosticFormat;
import org.pendant.language.source.Source;
import org.pendant.script.vm.ScriptFailure;

/** Report: how messages that are not those of the script read on standard error. */
final class Report {
  /** Of a deeper call stack (endless recursion) only the ends are shown. */
  private static final int MAX_CALLS = 20;

  private static final int INNERMOST_CALLS = 10;

  private Report() {}

  /** What the compiler says about {@code source}. */
  static List<String> diagnostics(Source source, List<Diagnostic> diagnostics) {
    return diagnostics.stream().map(each -> format(source, each)).toList();
  }

  /** Why the program in {@code source} failed, with the script's call stack, innermost first. */
  static List<String> failure(Source source, ScriptFailure failure) {
    Diagnostic diagnostic =
        Diagnostic.error(failure.code(), failure.range(), failure.message(), "");
    List<String> lines = new ArrayList<>();
    lines.add(format(source, diagnostic));
    int depth = failure.stack().size();
    for (int i = 0; i < depth; i++) {
      if (depth > MAX_CALLS && i == INNERMOST_CALLS) {
        int left = depth - MAX_CALLS;
        lines.add("  ... " + text("moreCalls", left));
        i += left;
      }
      ScriptFailure.StackEntry entry = failure.stack().get(i);
      lines.add("  " + text("inFunction", entry.function(), entry.line()));
    }
    return lines;
  }

  private static String format(Source source, Diagnostic diagnostic) {
    return DiagnosticFormat.format(
        source,
        diagnostic,
        text(diagnostic.isError() ? "error" : "warning"),
        CommandLanguage.shown(ByteText.decoded(diagnostic.message())));
  }

  /** A complaint about all of {@code source}. */
  static String error(Source source, String message) {
    return text("errorIn", source.name(), message);
  }

  /** A remark about all of {@code source}. */
  static String note(Source source, String message) {
    return text("noteIn", source.name(), message);
  }

  /** A log line of the controller: where the program was if it knows, else its file. */
  static String logEntry(Source source, LogEntry entry) {
    return (entry.place().isEmpty() ? source.name() + ": " : "") + logEntry(entry);
  }

  /** A log line of a controller, with the place that the program was at if it knows. */
  static String logEntry(LogEntry entry) {
    String place = entry.place().map(each -> each.source() + ":" + each.line() + ": ").orElse("");
    String kind =
        switch (entry.level()) {
          case INFO -> text("note");
          case WARNING -> text("warning");
          case ERROR -> text("error");
        };
    return place + kind + ": " + CommandLanguage.shown(ByteText.decoded(entry.text()));
  }

  /** A popup, as there is no screen to show it on. */
  static String popup(Popup popup) {
    String kind =
        switch (popup.severity()) {
          case MESSAGE -> text("popup");
          case WARNING -> text("popupWarning");
          case ERROR -> text("popupError");
        };
    return kind + ": " + ByteText.decoded(popup.title() + ": " + popup.text());
  }
}
