package org.pendant.language.check;

import static org.pendant.language.check.CheckTexts.text;

import java.util.HashSet;
import java.util.Set;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement.Definition;

/** Definition check: checks definitions: their heads, then their bodies. */
final class DefinitionCheck {
  private final CheckRun run;

  DefinitionCheck(CheckRun run) {
    this.run = run;
  }

  /**
   * Checks a definition that is not the program itself.
   *
   * @param defined the names already defined beside it; its own is added
   */
  void check(Definition definition, FunctionScope scope, Set<String> defined) {
    FunctionState state = new FunctionState(scope, run.graph().node(definition));
    head(definition, state, defined);
    if (run.known().isPresent()) {
      run.known().get().check(definition, state, run);
    } else {
      new StatementCheck(run, state).block(definition.body());
    }
  }

  /** Checks the name and the parameters alone; their defaults are part of each call. */
  void head(Definition definition, FunctionState state, Set<String> defined) {
    String name = definition.name();
    if (!defined.add(name)) {
      error("duplicate-definition", definition.nameRange(), text("definedTwice", name));
    } else if (run.builtin(name).isPresent()) {
      run.findings().warning("hides-builtin", definition.nameRange(), text("hidesBuiltIn", name));
    }
    ExpressionCheck defaults = new ExpressionCheck(run, state);
    Set<String> names = new HashSet<>();
    for (ParameterDeclaration parameter : definition.parameters()) {
      if (!names.add(parameter.name())) {
        error(
            "duplicate-parameter",
            parameter.range(),
            text("parameterTwice", name, parameter.name()));
      }
      parameter.defaultValue().ifPresent(defaults::check);
      state.flow().assigned(state.scope().resolve(parameter.name(), parameter.range().start()));
    }
  }

  private void error(String code, SourceRange range, String message) {
    run.findings().error(code, range, message);
  }
}
