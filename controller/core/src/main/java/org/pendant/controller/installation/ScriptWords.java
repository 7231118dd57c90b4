package org.pendant.controller.installation;

import static org.pendant.controller.installation.SetupTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Statement;

/** Script words: what programs can take as a name, and as a value. */
final class ScriptWords {
  private ScriptWords() {}

  /** Whether a variable can be called that. */
  static boolean isName(String text) {
    return text.matches("[A-Za-z_][A-Za-z_0-9]*") && assigned(parse(text + " = 0")).isPresent();
  }

  /** Why a text is no expression of the language; empty if it is one. */
  static Optional<String> valueProblem(String text) {
    if (text.isBlank()) {
      return Optional.of(text("noValue"));
    }
    if (text.chars().anyMatch(c -> c < ' ' || c == 0x7f)) {
      return Optional.of(text("valueLine"));
    }
    ParseResult read = parse("v = " + text);
    Optional<Diagnostic> error =
        read.diagnostics().stream().filter(Diagnostic::isError).findFirst();
    if (error.isPresent()) {
      return Optional.of(text("valueRefused", text, error.get().message()));
    }
    return assigned(read).isPresent() ? Optional.empty() : Optional.of(text("valueLiteral", text));
  }

  private static ParseResult parse(String text) {
    return ScriptParser.parseLine(Source.of("installation", text.getBytes(StandardCharsets.UTF_8)));
  }

  /** The value of an assignment that is all there is. */
  private static Optional<Expression> assigned(ParseResult read) {
    List<Statement> statements = read.script().statements();
    return read.ok()
            && statements.size() == 1
            && statements.getFirst() instanceof Statement.Assign assign
        ? Optional.of(assign.value())
        : Optional.empty();
  }
}
