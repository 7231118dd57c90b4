package org.pendant.language.check;

import java.util.List;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Script;

/** Parses and checks the small programs of these tests. */
final class Checks {
  private Checks() {}

  static Script parse(String text) {
    ParseResult result = ScriptParser.parseProgram(Source.of("test.script", text));
    if (!result.diagnostics().isEmpty()) {
      throw new IllegalArgumentException(result.diagnostics() + " in " + text);
    }
    return result.script();
  }

  static List<Diagnostic> diagnostics(String text) {
    return Checker.check(ProgramForm.of(parse(text)), new SmallCatalogue());
  }

  /** Everything found, as {@code line:code}. */
  static List<String> found(String text) {
    Source source = Source.of("test.script", text);
    return diagnostics(text).stream()
        .map(found -> source.line(found.range().start()) + ":" + found.code())
        .toList();
  }

  /** What is found in a program of which {@code body} is the body, from line 2 on. */
  static List<String> foundInBody(String body) {
    return found("def prog():\n" + body + "\nend\n");
  }

  /** The one message found in a program of which {@code body} is the body. */
  static String message(String body) {
    List<Diagnostic> found = diagnostics("def prog():\n" + body + "\nend\n");
    if (found.size() != 1) {
      throw new IllegalArgumentException(found + " in " + body);
    }
    return found.getFirst().message();
  }
}
