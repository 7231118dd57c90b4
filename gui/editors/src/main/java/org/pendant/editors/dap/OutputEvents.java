package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import org.eclipse.lsp4j.debug.OutputEventArguments;
import org.eclipse.lsp4j.debug.OutputEventArgumentsCategory;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.controller.state.ControllerState;
import org.pendant.editors.dap.run.RunResult;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.DiagnosticFormat;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.script.vm.ScriptFailure;

/** Output events: what a program and its robot say, in the form that a client shows. */
final class OutputEvents {
  /** Of a deeper call stack only the innermost calls are shown. */
  static final int MAX_CALLS = 20;

  private final IntFunction<Optional<String>> node;
  private final Source source;
  private final DebuggedText text;

  /**
   * Of a program.
   *
   * @param node which node of a tree a line belongs to
   */
  OutputEvents(IntFunction<Optional<String>> node, DebuggedText text) {
    this.node = node;
    this.text = text;
    source = text.source();
  }

  /** What a snapshot has that is new, of log lines after number {@code after}. */
  List<OutputEventArguments> of(ControllerState state, long after) {
    if (state.newestEntry() <= after && state.newPopups().isEmpty()) {
      return List.of();
    }
    List<OutputEventArguments> all = new ArrayList<>();
    state.newEntries().stream()
        .filter(entry -> entry.number() > after)
        // why a program ended is told with its place when it has ended
        .filter(entry -> entry.origin() != LogEntry.Origin.ENDING)
        .map(this::of)
        .forEach(all::add);
    state.newPopups().stream().map(this::of).forEach(all::add);
    return all;
  }

  private OutputEventArguments of(LogEntry entry) {
    String words = ByteText.decoded(entry.text());
    OutputEventArguments told =
        switch (entry.origin()) {
          case SCRIPT -> output(OutputEventArgumentsCategory.STDOUT, words);
          default ->
              switch (entry.level()) {
                case INFO -> output(OutputEventArgumentsCategory.CONSOLE, shown(words));
                case WARNING ->
                    output(
                        OutputEventArgumentsCategory.CONSOLE,
                        shown(DebugAdapterTexts.text("warning", words)));
                case ERROR ->
                    output(
                        OutputEventArgumentsCategory.STDERR,
                        shown(DebugAdapterTexts.text("error", words)));
              };
        };
    entry
        .place()
        .filter(place -> place.source().equals(source.name()))
        .ifPresent(place -> at(told, place.line()));
    return told;
  }

  private OutputEventArguments of(Popup popup) {
    String words = ByteText.decoded(popup.title() + ": " + popup.text());
    return output(
        OutputEventArgumentsCategory.CONSOLE,
        switch (popup.severity()) {
          case MESSAGE -> shown(DebugAdapterTexts.text("popup", words), words);
          case WARNING -> shown(DebugAdapterTexts.text("popupWarning", words), words);
          case ERROR -> shown(DebugAdapterTexts.text("popupError", words), words);
        });
  }

  private void at(OutputEventArguments told, int line) {
    told.setSource(text.asSource());
    told.setLine(text.form().line(line));
  }

  private void at(OutputEventArguments told, SourceRange range) {
    DebuggedText.Place place = text.start(range);
    told.setSource(text.asSource());
    told.setLine(place.line());
    told.setColumn(place.column());
  }

  /** A mistake or a doubt about the text. */
  OutputEventArguments of(Diagnostic diagnostic) {
    OutputEventArguments told =
        output(
            diagnostic.isError()
                ? OutputEventArgumentsCategory.STDERR
                : OutputEventArgumentsCategory.CONSOLE,
            formatted(diagnostic));
    at(told, diagnostic.range());
    return told;
  }

  /** Why a program ended that did not end by itself. */
  Optional<OutputEventArguments> of(RunResult result) {
    if (result.failure().isPresent()) {
      ScriptFailure failure = result.failure().get();
      OutputEventArguments told =
          output(OutputEventArgumentsCategory.STDERR, words(failure) + node(failure.line()));
      at(told, failure.range());
      return Optional.of(told);
    }
    return result
        .reason()
        .map(
            why -> {
              OutputEventArguments told =
                  output(
                      OutputEventArgumentsCategory.STDERR,
                      source.name()
                          + ": "
                          + shown(
                              DebugAdapterTexts.text(
                                  "stoppedInLine", result.line(), ByteText.decoded(why)))
                          + node(result.line()));
              if (result.line() > 0) {
                at(told, result.line());
              }
              return told;
            });
  }

  private String words(ScriptFailure failure) {
    StringBuilder words =
        new StringBuilder(
            formatted(Diagnostic.error(failure.code(), failure.range(), failure.message(), "")));
    List<ScriptFailure.StackEntry> stack = failure.stack();
    stack.stream()
        .limit(MAX_CALLS)
        .forEach(
            each ->
                words
                    .append("\n  ")
                    .append(shown(DebugAdapterTexts.text("call", each.function(), each.line()))));
    if (stack.size() > MAX_CALLS) {
      words
          .append("\n  ")
          .append(shown(DebugAdapterTexts.text("moreCalls", stack.size() - MAX_CALLS)));
    }
    return words.toString();
  }

  /** The node of the tree that a line belongs to, as a line of its own. */
  private String node(int line) {
    return node.apply(line)
        .map(found -> "\n" + shown(found + DebugAdapterTexts.text("stoppedHere")))
        .orElse("");
  }

  private String shown(String message) {
    return text.form().shown(message);
  }

  private String shown(String message, String written) {
    return text.form().language().shown(message, written);
  }

  /** With the line of the text below it, which is the people's own. */
  private String formatted(Diagnostic diagnostic) {
    String all = DiagnosticFormat.format(source, diagnostic);
    int end = all.indexOf(System.lineSeparator());
    return shown(all.substring(0, end)) + all.substring(end);
  }

  /** A remark about the program. */
  OutputEventArguments note(String words) {
    return output(
        OutputEventArgumentsCategory.CONSOLE,
        shown(DebugAdapterTexts.text("note", source.name(), words)));
  }

  /** A line. */
  static OutputEventArguments output(String category, String words) {
    OutputEventArguments told = new OutputEventArguments();
    told.setCategory(category);
    told.setOutput(words + "\n");
    return told;
  }
}
