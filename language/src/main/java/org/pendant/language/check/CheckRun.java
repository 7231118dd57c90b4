package org.pendant.language.check;

import static org.pendant.language.check.CheckTexts.text;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Signature;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.DefinitionKind;

/** Check run: what all functions of one check share. */
final class CheckRun {
  /** The one built-in that the language itself must know: it opens a running program to lines. */
  private static final String INTERPRETER_MODE = "interpreter_mode";

  private final Catalogue catalogue;
  private final Survey survey;
  private final boolean interpreted;
  private final boolean library;
  private final Diagnostics findings = new Diagnostics();
  private final Diagnostics unassigned = new Diagnostics();
  private final CallGraph graph = new CallGraph();
  private final Nearest nearest = new Nearest();
  private final Map<String, Optional<Builtin>> builtins = new HashMap<>();
  private final IdentityHashMap<Definition, FunctionHead> heads = new IdentityHashMap<>();
  private final Set<String> deprecated = new HashSet<>();
  private final Map<String, Optional<String>> functionOffers = new HashMap<>();
  private final Map<String, Optional<String>> variableOffers = new HashMap<>();
  private final Optional<KnownBodies> known;
  private boolean entersInterpreterMode;
  private int special;

  /** A built-in function and what calls of it must look like. */
  record Builtin(Signature signature, FunctionHead head) {}

  /**
   * A run over a program or one line.
   *
   * @param interpreted whether it is a line of interpreter mode
   * @param library whether names may come from a program around it
   * @param known what an earlier check has said
   */
  CheckRun(
      Catalogue catalogue,
      Survey survey,
      boolean interpreted,
      boolean library,
      Optional<KnownBodies> known) {
    this.catalogue = catalogue;
    this.survey = survey;
    this.interpreted = interpreted;
    this.library = library;
    this.known = known;
  }

  Optional<KnownBodies> known() {
    return known;
  }

  /** How often something was said or noted that does not follow from one definition alone. */
  int special() {
    return special;
  }

  Catalogue catalogue() {
    return catalogue;
  }

  Survey survey() {
    return survey;
  }

  boolean interpreted() {
    return interpreted;
  }

  Diagnostics findings() {
    return findings;
  }

  CallGraph graph() {
    return graph;
  }

  FunctionHead head(Definition definition) {
    return heads.computeIfAbsent(definition, FunctionHead::of);
  }

  /** The built-in function of this name, if there is one. */
  Optional<Builtin> builtin(String name) {
    return builtins.computeIfAbsent(
        name,
        _ -> catalogue.function(name).map(found -> new Builtin(found, FunctionHead.of(found))));
  }

  /**
   * A statement that fails if it ever runs: robots start a program that has one. A line of
   * interpreter mode runs at once, so it is refused.
   */
  void failsWhenItRuns(String code, SourceRange range, String message) {
    if (interpreted) {
      findings.error(code, range, message);
    } else {
      findings.warning(code, range, message);
    }
  }

  /** Kept apart: lines of interpreter mode may assign what the program does not. */
  void unassigned(SourceRange range, String message) {
    if (interpreted) {
      unassigned.error("unassigned-variable", range, message);
    } else {
      unassigned.warning("unassigned-variable", range, message);
    }
  }

  /** What fails only if no line of interpreter mode comes before it. */
  Diagnostics unassigned() {
    return unassigned;
  }

  /** Everything found, in the order of the text. */
  Diagnostics finished() {
    graph.reportEndlessLoops(findings);
    if (!entersInterpreterMode) {
      findings.addAll(unassigned.sorted());
    }
    return findings;
  }

  /** What is to say about a built-in beside its arguments. */
  void calls(Signature signature, SourceRange range, FunctionScope scope) {
    deprecated(signature, signature.name(), range, "");
    if (signature.name().equals(INTERPRETER_MODE)) {
      entersInterpreterMode = true;
      special++;
      if (interpreted || insideThread(scope)) {
        findings.error(
            "interpreter-mode",
            range,
            interpreted
                ? text("calledByInterpretedLine", INTERPRETER_MODE)
                : text("calledByThread", INTERPRETER_MODE));
      }
    }
  }

  /**
   * What is to say about an assignment to an output beside its arguments. It is a call of a
   * built-in that the text does not name, so the warning does not either.
   */
  void assignsOutput(Expression.Call call) {
    builtin(call.function())
        .ifPresent(
            builtin ->
                deprecated(
                    builtin.signature(),
                    OutputAssignment.WRITTEN,
                    call.nameRange(),
                    OutputAssignment.ARGUMENTS));
  }

  /**
   * Says once that there is a successor of a built-in.
   *
   * @param written how the text calls it
   * @param arguments those of the successor, where they are not written in the same way
   */
  private void deprecated(
      Signature signature, String written, SourceRange range, String arguments) {
    if (signature.deprecated().isEmpty()) {
      return;
    }
    special++;
    if (deprecated.add(signature.name())) {
      findings.warning(
          "deprecated", range, text("deprecated", written, signature.deprecated() + arguments));
    }
  }

  void unknownFunction(String name, SourceRange range, FunctionScope scope) {
    special++;
    if (scope.binds(name) || scope.globals().contains(name)) {
      findings.nameNotFound("unknown-function", name, range, text("variableIsCalled", name));
      return;
    }
    Optional<String> absence = catalogue.absence(name);
    if (absence.isPresent()) {
      findings.nameNotFound(MissingNames.FUNCTION, name, range, absence.get());
      return;
    }
    String message =
        library ? text("functionNotInLibrary", name) : text("functionNotDefined", name);
    missing(
        MissingNames.FUNCTION,
        name,
        range,
        offering(message, functionOffers.computeIfAbsent(name, _ -> nearestFunction(name, scope))));
  }

  /** In a library a name that it lacks may be one of the program that takes it in. */
  private void missing(String code, String name, SourceRange range, String message) {
    if (library) {
      findings.warning(code, range, message);
    } else {
      findings.nameNotFound(code, name, range, message);
    }
  }

  void unknownVariable(String name, SourceRange range, FunctionScope scope) {
    special++;
    String message =
        library ? text("variableNotInLibrary", name) : text("variableNeverAssigned", name);
    failsWhenItRuns(
        MissingNames.VARIABLE,
        range,
        scope.function(name).isPresent() || builtin(name).isPresent()
            ? text("needsParentheses", message, name)
            : offering(
                message,
                variableOffers.computeIfAbsent(name, _ -> nearest(name, () -> variables(scope)))));
  }

  private List<String> functions(FunctionScope scope) {
    List<String> functions = new ArrayList<>(scope.visibleFunctions());
    for (Signature signature : catalogue.all()) {
      if (signature.receiver().isEmpty()) {
        functions.add(signature.name());
      }
    }
    functions.add(Inference.STRUCT);
    return functions;
  }

  private static List<String> variables(FunctionScope scope) {
    List<String> variables = new ArrayList<>(List.of("True", "False", "None"));
    variables.addAll(scope.locals());
    variables.addAll(scope.globals());
    return variables;
  }

  /** A function that is not deprecated, if there is one. */
  private Optional<String> nearestFunction(String name, FunctionScope scope) {
    return nearest
        .to(name, () -> functions(scope))
        .map(found -> scope.function(found).isPresent() ? found : catalogue.current(found));
  }

  /** The name probably meant, if there is one. */
  Optional<String> nearest(String name, Supplier<? extends Collection<String>> candidates) {
    special++;
    return nearest.to(name, candidates);
  }

  /** A message that offers the name probably meant. */
  static String offering(String message, Optional<String> near) {
    return near.map(each -> text("didYouMean", message, each)).orElse(message);
  }

  private static boolean insideThread(FunctionScope scope) {
    return scope
        .definition()
        .filter(definition -> definition.kind() == DefinitionKind.THREAD)
        .isPresent();
  }
}
