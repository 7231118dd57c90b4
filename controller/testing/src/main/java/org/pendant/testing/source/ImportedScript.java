package org.pendant.testing.source;

import java.util.List;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.check.ProgramForm;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Effect;

/**
 * Imported script: what another script brings into a file of tests: its functions, and the values
 * that it gives names before it does anything.
 *
 * @param script its statements alone
 * @param builtins tell which calls only compute
 */
record ImportedScript(Script script, Builtins<ControlBox> builtins) {

  /** Adds what it brings in to what there is. */
  void into(List<Statement> constants, List<Statement> functions) {
    ProgramForm form = ProgramForm.of(script);
    functions.addAll(form.siblings());
    // a program with functions inside lends those; one without may as well be a function itself
    form.entry()
        .filter(entry -> entry.body().stream().noneMatch(Definition.class::isInstance))
        .ifPresent(functions::add);
    boolean leading = true;
    for (Statement each : form.body()) {
      switch (each) {
        case Definition definition -> functions.add(definition);
        case Statement.Assign assign -> {
          if (leading && isValue(assign)) {
            constants.add(
                new Statement.Assign(
                    Statement.Qualifier.FREE, assign.target(), assign.value(), assign.range()));
          }
        }
        case Statement.Label _ -> {}
        default -> leading = false;
      }
    }
  }

  /** Whether it only gives a value a name, which running it anywhere does as well. */
  private boolean isValue(Statement statement) {
    boolean[] acts = new boolean[1];
    SyntaxWalk.ownOf(List.of(statement), each -> acts[0] |= acts(each));
    return !acts[0];
  }

  private boolean acts(Expression expression) {
    return switch (expression) {
      case Call call ->
          !call.function().equals("struct")
              && builtins
                  .find(call.function())
                  .filter(each -> each.effect() == Effect.COMPUTES)
                  .isEmpty();
      case Expression.MethodCall _, Expression.Run _ -> true;
      default -> false;
    };
  }
}
