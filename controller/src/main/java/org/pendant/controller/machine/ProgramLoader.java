package org.pendant.controller.machine;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.call.Builtins;
import org.pendant.language.check.Checker;
import org.pendant.language.check.ProgramForm;
import org.pendant.language.check.Scopes;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;

/** The way from text to a program: parse, check, compile. Pure; any thread may call it. */
public final class ProgramLoader {
  private ProgramLoader() {}

  /** Loads a program file or a program received over a socket. */
  public static Loaded load(Source source, Builtins builtins) {
    ParseResult parsed = ScriptParser.parseProgram(source);
    List<Diagnostic> diagnostics = new ArrayList<>(parsed.diagnostics());
    if (diagnostics.stream().anyMatch(Diagnostic::isError)) {
      return new Loaded(Optional.empty(), diagnostics);
    }
    ProgramForm form = ProgramForm.of(parsed.script());
    Scopes scopes = Scopes.of(form);
    diagnostics.addAll(Checker.check(form, scopes, builtins));
    if (diagnostics.stream().anyMatch(Diagnostic::isError)) {
      return new Loaded(Optional.empty(), diagnostics);
    }
    try {
      Program program = new Compiler(source, form, scopes, builtins).compile();
      return new Loaded(Optional.of(program), diagnostics);
    } catch (ProgramTooLarge e) {
      diagnostics.add(
          Diagnostic.error("program-too-large", new SourceRange(0, 0), e.getMessage(), ""));
      return new Loaded(Optional.empty(), diagnostics);
    }
  }
}
