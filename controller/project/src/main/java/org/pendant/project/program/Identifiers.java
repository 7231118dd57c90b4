package org.pendant.project.program;

import static org.pendant.project.program.ProgramTreeTexts.text;

import java.util.Optional;
import java.util.regex.Pattern;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.LexemeReader;
import org.pendant.language.source.Source;

/** Identifiers: which texts the language takes as names of variables and functions. */
public final class Identifiers {
  private static final Pattern FORM = Pattern.compile("[A-Za-z_][A-Za-z_0-9]*");

  private Identifiers() {}

  /** Whether a text has the characters of a name. */
  public static boolean wellFormed(String text) {
    return FORM.matcher(text).matches();
  }

  /** Why a text has not the characters of a name; empty if it has. */
  public static Optional<String> formRefusal(String text) {
    return wellFormed(text) ? Optional.empty() : Optional.of(text("noName", text));
  }

  /** Why a text cannot be a name; empty if it can, unless something else has it already. */
  public static Optional<String> refusal(String text) {
    return formRefusal(text).or(() -> keywordRefusal(text));
  }

  private static Optional<String> keywordRefusal(String text) {
    return LexemeReader.lexemes(Source.of("name", text)).getFirst().kind() == Lexeme.Kind.NAME
        ? Optional.empty()
        : Optional.of(text("keyword", text));
  }
}
