package org.pendant.language.parse;

import static org.pendant.language.parse.ParseTexts.text;

import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.BailErrorStrategy;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.misc.ParseCancellationException;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;

/**
 * Script parser: reads URScript text.
 *
 * <p>The passes: {@link TokenPass} makes tokens and bounds how deeply they nest; ANTLR's parser
 * runs once without recovery, as nearly every text is right; {@link StatementBuilder} makes our
 * tree. Only a text with an error is read again, by {@link RecoveringParse}.
 */
public final class ScriptParser {
  /** Texts above this many bytes are refused; real programs stay below half a megabyte. */
  public static final int MAX_BYTES = 4 << 20;

  private ScriptParser() {}

  /**
   * A script file: definitions and statements in any mix, so a whole program and a fragment that is
   * pasted into one are read alike.
   */
  public static ParseResult parseProgram(Source source) {
    return parse(source, new TokenPass(source, false));
  }

  /**
   * A script file as {@link #parseProgram} reads it, and its lexemes, by one pass over the text.
   */
  public static ReadText read(Source source) {
    TokenPass pass = new TokenPass(source, true);
    Complaints complaints = new Complaints(source);
    List<Statement> statements = statements(source, pass, complaints);
    boolean whole = source.text().length() <= MAX_BYTES;
    Optional<LexemeTable> lexemes = pass.lexemes().filter(all -> whole);
    return new ReadText(
        result(source, statements, complaints),
        lexemes.orElseGet(() -> LexemeReader.lexemes(source)),
        pass.table(),
        complaints.places());
  }

  /**
   * As {@link #read(Source)}, for a text most of which is in one that was read before: what is the
   * same is not read again. The result is the same as without it.
   */
  public static ReadText read(Source source, ReadText before) {
    if (source.text().length() > MAX_BYTES) {
      return read(source);
    }
    Optional<TextChange> change = TextChange.of(before, source);
    return change.isEmpty() ? read(source) : read(source, before, change.get());
  }

  private static ReadText read(Source source, ReadText before, TextChange change) {
    Complaints complaints = new Complaints(source);
    EarlierStatements earlier = new EarlierStatements(before, change, complaints);
    TokenTable table = change.tokens();
    TokenArray tokens = new TokenArray(table, change.maker(), source);
    BailErrorStrategy strategy =
        new BailErrorStrategy() {
          @Override
          public void sync(Parser parser) {
            earlier.take(parser, tokens);
          }
        };
    List<Statement> statements =
        strict(source, tokens, complaints, strategy)
            .orElseGet(
                () -> {
                  complaints.clear();
                  return new RecoveringParse(source, complaints, Optional.of(earlier))
                      .parse(table.tokens(source, change.maker()), change.maker());
                });
    return new ReadText(
        result(source, statements, complaints),
        change.lexemes(),
        Optional.of(table),
        complaints.places());
  }

  private static ParseResult parse(Source source, TokenPass pass) {
    Complaints complaints = new Complaints(source);
    return result(source, statements(source, pass, complaints), complaints);
  }

  private static ParseResult result(
      Source source, List<Statement> statements, Complaints complaints) {
    SourceRange all = new SourceRange(0, source.text().length());
    return new ParseResult(new Script(source, statements, all), complaints.inOrder());
  }

  /** One line of interpreter mode (manual 13): one or more statements, definitions among them. */
  public static ParseResult parseLine(Source source) {
    return parseProgram(source);
  }

  private static List<Statement> statements(Source source, TokenPass pass, Complaints complaints) {
    int bytes = source.text().length();
    if (bytes > MAX_BYTES) {
      complaints.refuse(
          "source-too-large", text("sourceTooLarge", source.name(), bytes, MAX_BYTES));
      return List.of();
    }
    List<ScriptToken> tokens = pass.read();
    if (pass.tooDeep().isPresent()) {
      complaints.tooDeep(pass.tooDeep().get());
      return List.of();
    }
    TokenArray array = new TokenArray(tokens, pass.lexer());
    return strict(source, array, complaints, new BailErrorStrategy())
        .orElseGet(
            () -> {
              complaints.clear();
              return new RecoveringParse(source, complaints, Optional.empty())
                  .parse(tokens, pass.lexer());
            });
  }

  private static Optional<List<Statement>> strict(
      Source source, TokenArray tokens, Complaints complaints, BailErrorStrategy strategy) {
    BuildingParser parser = new BuildingParser(tokens, new StatementBuilder(source, complaints));
    parser.setErrorHandler(strategy);
    try {
      return Optional.of(parser.statements());
    } catch (ParseCancellationException stopped) {
      return Optional.empty();
    }
  }
}
