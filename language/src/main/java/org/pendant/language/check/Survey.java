package org.pendant.language.check;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Branch;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.Evaluate;
import org.pendant.language.syntax.Statement.If;
import org.pendant.language.syntax.Statement.Label;
import org.pendant.language.syntax.Statement.While;

/** Survey of all assignments: what each variable contains wherever it is assigned. */
final class Survey {
  private final Inference inference;
  private final Map<String, StaticType> globals = new HashMap<>();
  private final Map<FunctionScope, Map<String, StaticType>> locals = new HashMap<>();
  private final Map<String, StaticType> opening = new HashMap<>();
  private final Set<String> assignedInFunctions = new HashSet<>();

  private Survey(Inference inference) {
    this.inference = inference;
  }

  /** The survey of a whole program. */
  static Survey of(ProgramForm form, Scopes scopes, Inference inference) {
    Survey survey = new Survey(inference);
    FunctionScope main = scopes.mainScope();
    survey.look(main, form.body());
    for (Definition definition : scopes.definitions()) {
      FunctionScope scope = scopes.scope(definition);
      if (!scope.mainLevel()) {
        survey.look(scope, definition.body());
      }
    }
    form.entry().ifPresent(survey::lookAtParameters);
    survey.lookAtOpening(main, form.body());
    return survey;
  }

  /** One line of interpreter mode: what variables hold is not known from it alone. */
  static Survey nothingKnown(Inference inference) {
    return new Survey(inference);
  }

  /** What {@code binding} holds whenever it has a value. */
  StaticType kind(FunctionScope scope, Binding binding) {
    return switch (binding) {
      case Binding.Global(String name) ->
          opening.getOrDefault(name, globals.getOrDefault(name, StaticType.ANY));
      case Binding.Local(String name) ->
          locals.getOrDefault(scope, Map.of()).getOrDefault(name, StaticType.ANY);
    };
  }

  /** What the program's first statements certainly put into a global. */
  StaticType openingKind(Binding binding) {
    return switch (binding) {
      case Binding.Global(String name) -> opening.getOrDefault(name, StaticType.ANY);
      case Binding.Local _ -> StaticType.ANY;
    };
  }

  /** All that is known of global variables, for comparison. */
  List<Object> ofGlobals() {
    return List.of(Map.copyOf(globals), Map.copyOf(opening));
  }

  boolean assignedInFunctions(String global) {
    return assignedInFunctions.contains(global);
  }

  private void look(FunctionScope scope, List<Statement> statements) {
    for (Statement statement : statements) {
      if (statement instanceof Assign assign && assign.target() instanceof Name) {
        Binding binding = scope.target(assign);
        StaticType kind = inference.kind(assign.value(), scope);
        switch (binding) {
          case Binding.Global(String name) -> {
            globals.merge(name, kind, StaticType::or);
            if (!scope.mainLevel()) {
              assignedInFunctions.add(name);
            }
          }
          case Binding.Local(String name) -> {
            StaticType first = scope.startsAssigned(name) ? StaticType.ANY : kind;
            locals.computeIfAbsent(scope, _ -> new HashMap<>()).merge(name, first, StaticType::or);
          }
        }
      } else if (statement instanceof If choice) {
        for (Branch branch : choice.branches()) {
          look(scope, branch.body());
        }
        choice.otherwise().ifPresent(body -> look(scope, body));
      } else if (statement instanceof While loop) {
        look(scope, loop.body());
      }
    }
  }

  private void lookAtParameters(Definition entry) {
    for (ParameterDeclaration parameter : entry.parameters()) {
      globals.put(parameter.name(), StaticType.ANY);
    }
  }

  /** The statements before the first one that may branch or leave run in every run. */
  private void lookAtOpening(FunctionScope main, List<Statement> statements) {
    for (Statement statement : statements) {
      if (statement instanceof Assign assign) {
        if (assign.target() instanceof Name(String name, _)) {
          opening.putIfAbsent(name, inference.kind(assign.value(), main));
        }
      } else if (!(statement instanceof Evaluate
          || statement instanceof Label
          || statement instanceof Definition)) {
        return;
      }
    }
  }
}
