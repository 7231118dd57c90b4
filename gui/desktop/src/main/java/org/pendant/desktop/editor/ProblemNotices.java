package org.pendant.desktop.editor;

import java.util.List;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.parser.AbstractParser;
import org.fife.ui.rsyntaxtextarea.parser.DefaultParseResult;
import org.fife.ui.rsyntaxtextarea.parser.DefaultParserNotice;
import org.fife.ui.rsyntaxtextarea.parser.ParseResult;
import org.fife.ui.rsyntaxtextarea.parser.ParserNotice;
import org.pendant.desktop.editor.text.Problem;
import org.pendant.kit.theme.Palette;

/** Problem notices: hands problems that were found already to the text component and its stripe. */
final class ProblemNotices extends AbstractParser {
  /** Underlining thousands is no help and slows painting down. */
  private static final int MOST = 500;

  private List<Problem> problems = List.of();

  /** Takes the problems of the text as it is; whether they are others than before. */
  boolean set(List<Problem> found) {
    List<Problem> before = problems;
    problems = found.size() > MOST ? found.subList(0, MOST) : found;
    return !problems.equals(before);
  }

  @Override
  public ParseResult parse(RSyntaxDocument document, String style) {
    DefaultParseResult result = new DefaultParseResult(this);
    result.setParsedLines(0, document.getDefaultRootElement().getElementCount() - 1);
    for (Problem problem : problems) {
      int length = Math.max(1, problem.span().end() - problem.span().start());
      DefaultParserNotice notice =
          new DefaultParserNotice(
              this, problem.message(), problem.line() - 1, problem.span().start(), length);
      notice.setLevel(problem.isError() ? ParserNotice.Level.ERROR : ParserNotice.Level.WARNING);
      notice.setColor(problem.isError() ? Palette.error() : Palette.warning());
      result.addNotice(notice);
    }
    return result;
  }
}
