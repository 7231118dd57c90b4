package org.pendant.language.service;

import static org.pendant.language.service.ServiceTexts.text;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.LexemeReader;
import org.pendant.language.service.RenameResult.Refused;
import org.pendant.language.service.RenameResult.Renamed;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;

/**
 * Renames a variable, parameter or function.
 *
 * <p>Whether the new name is free is not guessed from scopes: the names of the changed text must
 * fall into the same groups as before, occurrence by occurrence, or the renaming is refused.
 */
final class Renaming {
  private static final Pattern IDENTIFIER = Pattern.compile("[A-Za-z_][A-Za-z_0-9]*");

  private final ScriptAnalysis analysis;
  private final String newName;

  Renaming(ScriptAnalysis analysis, String newName) {
    this.analysis = analysis;
    this.newName = newName;
  }

  RenameResult at(int offset) {
    Optional<Diagnostic> error = analysis.syntaxError();
    if (error.isPresent()) {
      int line = analysis.source().line(error.get().range().start());
      return new Refused(text("unreadableLine", line));
    }
    return analysis
        .index()
        .at(offset)
        .map(this::renamed)
        .orElseGet(() -> new Refused(text("noName")));
  }

  private RenameResult renamed(Occurrence occurrence) {
    Symbol symbol = occurrence.symbol();
    Optional<String> refusal = fixed(symbol).or(this::unusable);
    if (refusal.isPresent()) {
      return new Refused(refusal.get());
    }
    List<TextEdit> edits =
        analysis.index().of(symbol).stream()
            .map(other -> new TextEdit(other.range(), newName))
            .toList();
    if (newName.equals(symbol.name())) {
      return new Renamed(List.of());
    }
    ScriptAnalysis after =
        ScriptAnalysis.of(TextEdit.apply(analysis.source(), edits), analysis.catalogue());
    return conflict(after).<RenameResult>map(Refused::new).orElseGet(() -> new Renamed(edits));
  }

  private static Optional<String> fixed(Symbol symbol) {
    return switch (symbol) {
      case Symbol.Builtin _, Symbol.Method _, Symbol.NamedArgument _ ->
          Optional.of(text("builtIn", symbol.name()));
      case Symbol.Member _ -> Optional.of(text("memberOfStructs", symbol.name()));
      case Symbol.Global _, Symbol.Local _, Symbol.Parameter _, Symbol.Function _ ->
          Optional.empty();
      case Symbol.Unknown _ -> Optional.of(text("nothingDefines", symbol.name()));
    };
  }

  private Optional<String> unusable() {
    if (!IDENTIFIER.matcher(newName).matches()) {
      return Optional.of(text("invalidName", newName));
    }
    Lexeme lexeme = LexemeReader.lexemes(Source.of("name", newName)).getFirst();
    if (lexeme.kind() != Lexeme.Kind.NAME) {
      return Optional.of(text("reservedWord", newName));
    }
    return analysis.signatures().builtin(newName).map(_ -> text("builtInFunction", newName));
  }

  /** The first occurrence that would mean something else than before. */
  private Optional<String> conflict(ScriptAnalysis after) {
    List<Occurrence> old = analysis.index().all();
    List<Occurrence> now = after.index().all();
    if (old.size() != now.size()) {
      return Optional.of(text("changesMeaning", newName));
    }
    Map<Symbol, Symbol> forward = new HashMap<>();
    Map<Symbol, Symbol> backward = new HashMap<>();
    for (int i = 0; i < old.size(); i++) {
      Symbol before = old.get(i).symbol();
      Symbol later = now.get(i).symbol();
      boolean same =
          before.getClass() == later.getClass()
              && later.equals(forward.computeIfAbsent(before, _ -> later))
              && before.equals(backward.computeIfAbsent(later, _ -> before));
      if (!same) {
        return Optional.of(taken(old.get(i)));
      }
    }
    return Optional.empty();
  }

  private String taken(Occurrence met) {
    Occurrence shown =
        analysis.index().all().stream()
            .filter(other -> other.symbol().name().equals(newName))
            .findFirst()
            .orElse(met);
    return text("nameTaken", newName, analysis.source().line(shown.range().start()));
  }
}
