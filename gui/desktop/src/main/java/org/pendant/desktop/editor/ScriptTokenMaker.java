package org.pendant.desktop.editor;

import javax.swing.text.Document;
import javax.swing.text.Segment;
import org.fife.ui.rsyntaxtextarea.Token;
import org.fife.ui.rsyntaxtextarea.TokenMakerBase;
import org.fife.ui.rsyntaxtextarea.TokenTypes;
import org.pendant.desktop.editor.text.LineColours;
import org.pendant.desktop.editor.text.StyledLine;
import org.pendant.language.service.HighlightToken.Style;

/**
 * Token maker: hands the colours of lines to the text component. No line depends on the one before.
 */
final class ScriptTokenMaker extends TokenMakerBase {
  private final Document document;
  private final LineColours colours;

  ScriptTokenMaker(Document document, LineColours colours) {
    this.document = document;
    this.colours = colours;
  }

  /** The component's word for a style. */
  static int type(Style style) {
    return switch (style) {
      case KEYWORD -> TokenTypes.RESERVED_WORD;
      case FUNCTION -> TokenTypes.FUNCTION;
      case BUILTIN -> TokenTypes.RESERVED_WORD_2;
      case VARIABLE -> TokenTypes.VARIABLE;
      case PARAMETER -> TokenTypes.DATA_TYPE;
      case MEMBER -> TokenTypes.MARKUP_TAG_ATTRIBUTE;
      case NUMBER -> TokenTypes.LITERAL_NUMBER_FLOAT;
      case STRING -> TokenTypes.LITERAL_STRING_DOUBLE_QUOTE;
      case COMMENT -> TokenTypes.COMMENT_EOL;
      case LABEL -> TokenTypes.PREPROCESSOR;
      case OPERATOR -> TokenTypes.OPERATOR;
      case UNKNOWN -> TokenTypes.IDENTIFIER;
    };
  }

  @Override
  public int getLastTokenTypeOnLine(Segment text, int initialTokenType) {
    return TokenTypes.NULL;
  }

  @Override
  public String[] getLineCommentStartAndEnd(int languageIndex) {
    return new String[] {"# ", null};
  }

  @Override
  public Token getTokenList(Segment text, int initialTokenType, int startOffset) {
    resetTokenList();
    int line = document.getDefaultRootElement().getElementIndex(startOffset);
    int done = 0;
    for (StyledLine.Run run : colours.line(line, text).runs()) {
      addPlain(text, done, run.start(), startOffset);
      add(text, run.start(), run.end(), type(run.style()), startOffset);
      done = run.end();
    }
    addPlain(text, done, text.count, startOffset);
    addNullToken();
    return firstToken;
  }

  /** What has no colour: blanks, brackets (which the component matches), and other signs. */
  private void addPlain(Segment text, int from, int to, int startOffset) {
    int start = from;
    while (start < to) {
      int type = plainType(text.array[text.offset + start]);
      int end = start + 1;
      while (end < to
          && type != TokenTypes.SEPARATOR
          && plainType(text.array[text.offset + end]) == type) {
        end++;
      }
      add(text, start, end, type, startOffset);
      start = end;
    }
  }

  private void add(Segment text, int start, int end, int type, int startOffset) {
    addToken(text, text.offset + start, text.offset + end - 1, type, startOffset + start);
  }

  private static int plainType(char c) {
    if (c == ' ' || c == '\t') {
      return TokenTypes.WHITESPACE;
    }
    return "()[]{}".indexOf(c) >= 0 ? TokenTypes.SEPARATOR : TokenTypes.IDENTIFIER;
  }
}
