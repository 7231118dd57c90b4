package org.pendant.language.check;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Branch;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.If;
import org.pendant.language.syntax.Statement.Qualifier;
import org.pendant.language.syntax.Statement.While;

/**
 * Scope builder: walks statements once and files every assigned name and every definition in its
 * scope.
 */
final class ScopeBuilder {
  private final boolean growing;
  private final Set<String> globals = new LinkedHashSet<>();
  private final IdentityHashMap<Definition, FunctionScope> scopes = new IdentityHashMap<>();
  private final List<Definition> definitions = new ArrayList<>();

  /**
   * A builder for a whole program, or for one more line of a running one.
   *
   * @param growing whether assignments may declare globals
   */
  ScopeBuilder(boolean growing) {
    this.growing = growing;
  }

  Set<String> globals() {
    return globals;
  }

  IdentityHashMap<Definition, FunctionScope> scopes() {
    return scopes;
  }

  List<Definition> definitions() {
    return definitions;
  }

  void define(FunctionScope parent, Definition definition) {
    FunctionScope scope = FunctionScope.function(definition, parent);
    enter(parent, definition, scope);
    collect(scope, definition.body());
  }

  void enter(FunctionScope parent, Definition definition, FunctionScope scope) {
    parent.declare(definition, scope);
    scopes.put(definition, scope);
    definitions.add(definition);
  }

  void collect(FunctionScope scope, List<Statement> statements) {
    for (Statement statement : statements) {
      switch (statement) {
        case Assign assign -> bind(scope, assign);
        case If choice -> {
          for (Branch branch : choice.branches()) {
            collect(scope, branch.body());
          }
          choice.otherwise().ifPresent(body -> collect(scope, body));
        }
        case While loop -> collect(scope, loop.body());
        case Definition definition -> define(scope, definition);
        case Statement.Evaluate _,
            Statement.Break _,
            Statement.Continue _,
            Statement.Halt _,
            Statement.Pause _,
            Statement.Return _,
            Statement.Join _,
            Statement.Kill _,
            Statement.EnterCritical _,
            Statement.ExitCritical _,
            Statement.Label _ -> {}
      }
    }
  }

  private void bind(FunctionScope scope, Assign assign) {
    if (!(assign.target() instanceof Name name)) {
      return;
    }
    if (growing && (scope.mainLevel() || assign.qualifier() == Qualifier.GLOBAL)) {
      globals.add(name.name());
    } else if (assign.qualifier() != Qualifier.GLOBAL) {
      scope.bind(name.name(), assign);
    }
  }
}
