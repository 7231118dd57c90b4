package org.pendant.editors.lsp.provider;

import java.util.List;
import org.eclipse.lsp4j.SemanticTokenModifiers;
import org.eclipse.lsp4j.SemanticTokenTypes;
import org.eclipse.lsp4j.SemanticTokensLegend;
import org.pendant.language.service.HighlightToken.Style;

/** Token types: the names that the protocol has for the colours of a text. */
public final class TokenTypes {
  /** In the order of the numbers by which tokens name them. */
  private static final List<String> TYPES =
      List.of(
          SemanticTokenTypes.Keyword,
          SemanticTokenTypes.Function,
          SemanticTokenTypes.Variable,
          SemanticTokenTypes.Parameter,
          SemanticTokenTypes.Property,
          SemanticTokenTypes.Number,
          SemanticTokenTypes.String,
          SemanticTokenTypes.Comment,
          SemanticTokenTypes.Operator,
          SemanticTokenTypes.Decorator);

  private static final List<String> MODIFIERS =
      List.of(SemanticTokenModifiers.DefaultLibrary, SemanticTokenModifiers.Declaration);

  static final int DEFAULT_LIBRARY = 1;
  static final int DECLARATION = 2;

  private TokenTypes() {}

  /** What the numbers of types and modifiers mean. */
  public static SemanticTokensLegend legend() {
    return new SemanticTokensLegend(TYPES, MODIFIERS);
  }

  /** The number of the type; -1 for what has no colour of its own. */
  static int type(Style style) {
    return switch (style) {
      case KEYWORD -> 0;
      case FUNCTION, BUILTIN -> 1;
      case VARIABLE -> 2;
      case PARAMETER -> 3;
      case MEMBER -> 4;
      case NUMBER -> 5;
      case STRING -> 6;
      case COMMENT -> 7;
      case OPERATOR -> 8;
      case LABEL -> 9;
      case UNKNOWN -> -1;
    };
  }
}
