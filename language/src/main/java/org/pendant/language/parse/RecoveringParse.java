package org.pendant.language.parse;

import static org.pendant.language.parse.ParseTexts.text;

import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.TokenSource;
import org.antlr.v4.runtime.misc.ParseCancellationException;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Statement;

/**
 * Recovering parser: reads a text that has syntax errors and reports each of them once.
 *
 * <p>Typical mistakes with a clear meaning are reported and mended in the tokens ({@link
 * TokenRepair}), then blocks are balanced ({@link BlockRepair}), so that the parser meets only
 * errors inside one statement or head, from which {@link StatementRecovery} continues.
 */
final class RecoveringParse {
  private final Source source;
  private final Complaints complaints;
  private final Optional<EarlierStatements> earlier;

  /**
   * A parse of a source.
   *
   * @param earlier what is known of a text that differs little
   */
  RecoveringParse(Source source, Complaints complaints, Optional<EarlierStatements> earlier) {
    this.source = source;
    this.complaints = complaints;
    this.earlier = earlier;
  }

  /** What could be read; nothing when there are too many errors to continue. */
  List<Statement> parse(List<ScriptToken> broken, TokenSource tokenSource) {
    Optional<SourceRange> mark = TemplateMarks.first(source, broken);
    if (mark.isEmpty()) {
      return read(broken, tokenSource);
    }
    // What else seems wrong is mostly a mark too, and another text when they are filled in.
    complaints.add(
        "template", mark.get(), text("template", Wording.shortened(source.text(mark.get()))));
    complaints.note(new SourceRange(0, source.text().length()));
    return new RecoveringParse(source, new Complaints(source), Optional.empty())
        .read(broken, tokenSource);
  }

  private List<Statement> read(List<ScriptToken> broken, TokenSource tokenSource) {
    List<ScriptToken> mended = new TokenRepair(source, complaints).mend(broken);
    if (complaints.full()) {
      return List.of();
    }
    List<ScriptToken> balanced = new BlockRepair(source, complaints).balance(mended);
    if (complaints.full()) {
      return List.of();
    }
    TokenArray tokens = new TokenArray(balanced, tokenSource);
    BuildingParser parser = new BuildingParser(tokens, new StatementBuilder(source, complaints));
    parser.setErrorHandler(
        new StatementRecovery(tokens, complaints, new ErrorMessages(source, tokens), earlier));
    try {
      return parser.statements();
    } catch (ParseCancellationException tooMany) {
      return List.of();
    }
  }
}
