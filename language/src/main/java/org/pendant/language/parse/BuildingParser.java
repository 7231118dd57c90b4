package org.pendant.language.parse;

import java.util.List;
import org.antlr.v4.runtime.ParserRuleContext;
import org.pendant.language.syntax.Statement;

/**
 * The generated parser, which hands every statement to the builder as soon as it is complete and
 * then forgets ANTLR's tree of it: memory holds our tree and one path of ANTLR's.
 */
final class BuildingParser extends UrScriptParser {
  private final StatementBuilder builder;

  BuildingParser(TokenArray tokens, StatementBuilder builder) {
    super(tokens);
    this.builder = builder;
    removeErrorListeners();
  }

  /** The statements of the whole text. */
  List<Statement> statements() {
    return StatementBuilder.statements(script().statement());
  }

  @Override
  public void exitRule() {
    ParserRuleContext done = getContext();
    super.exitRule();
    if (done instanceof StatementContext statement && statement.exception == null) {
      statement.tree = builder.build(statement);
      statement.children = null;
    }
  }
}
