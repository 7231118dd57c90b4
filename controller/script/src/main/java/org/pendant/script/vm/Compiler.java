package org.pendant.script.vm;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.check.ProgramForm;
import org.pendant.language.check.Scopes;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.script.function.Builtins;

/** Compiler of a checked program. */
final class Compiler {
  private final Source source;
  private final ProgramForm form;
  private final Scopes scopes;
  private final Builtins<?> builtins;
  private final Optional<CoverageSlots> coverage;
  private final Linkage linkage;

  /**
   * @param covered whether runs mark what they reach
   */
  Compiler(Source source, ProgramForm form, Scopes scopes, Builtins<?> builtins, boolean covered) {
    this.source = source;
    this.form = form;
    this.scopes = scopes;
    this.builtins = builtins;
    coverage = covered ? Optional.of(new CoverageSlots()) : Optional.empty();
    linkage = new Linkage(coverage);
  }

  Program compile() {
    int main = linkage.reserve();
    form.entry().ifPresent(entry -> linkage.definitions().put(entry, main));
    // by identity: two equal definitions are two functions
    List<Definition> definitions =
        scopes.definitions().stream()
            .filter(definition -> !linkage.definitions().containsKey(definition))
            .toList();
    definitions.forEach(linkage::reserve);
    linkage.define(main, compileMain());
    for (Definition definition : definitions) {
      linkage.define(linkage.function(definition), compileFunction(definition));
    }
    return new Program(
        form.name(),
        source,
        form.kind() == ProgramForm.Kind.SECONDARY,
        scopes,
        linkage.definitions(),
        mainFunction(),
        linkage.tables(),
        linkage.labels(),
        coverage);
  }

  /** The function that the last statement of a fragment calls. */
  private OptionalInt mainFunction() {
    if (form.kind() == ProgramForm.Kind.FRAGMENT
        && !form.body().isEmpty()
        && form.body().getLast() instanceof Statement.Evaluate last
        && last.expression() instanceof Expression.Call call) {
      Optional<Definition> called = scopes.mainScope().function(call.function());
      if (called.isPresent()) {
        return OptionalInt.of(linkage.function(called.get()));
      }
    }
    return OptionalInt.empty();
  }

  private ScriptFunction compileMain() {
    StatementCompiler compiler = compiler(scopes.mainScope());
    form.entry()
        .ifPresent(
            entry -> {
              for (ParameterDeclaration parameter : entry.parameters()) {
                parameter
                    .defaultValue()
                    .ifPresent(value -> compiler.initialise(parameter.name(), value));
              }
            });
    compiler.statements(form.body());
    return compiler.finish(form.name(), form.entry().map(Definition::nameRange), 0);
  }

  private ScriptFunction compileFunction(Definition definition) {
    StatementCompiler compiler = compiler(scopes.scope(definition));
    compiler.defaults(definition.parameters());
    compiler.statements(definition.body());
    return compiler.finish(definition);
  }

  private StatementCompiler compiler(FunctionScope scope) {
    return new StatementCompiler(
        new FunctionContext(source, scope, linkage, scope.locals()), builtins);
  }

  /** Compiles the definitions that stand in an interpreted line, and the line itself. */
  static ScriptFunction compileLine(
      Source source,
      List<Statement> statements,
      FunctionScope scope,
      List<String> variables,
      Builtins<?> builtins,
      Linkage linkage) {
    for (Statement statement : statements) {
      if (statement instanceof Definition definition) {
        reserve(definition, linkage);
      }
    }
    for (Statement statement : statements) {
      if (statement instanceof Definition definition) {
        compileNested(source, definition, scope, builtins, linkage);
      }
    }
    StatementCompiler compiler =
        new StatementCompiler(new FunctionContext(source, scope, linkage, variables), builtins);
    compiler.statements(statements);
    return compiler.finishLine();
  }

  private static void reserve(Definition definition, Linkage linkage) {
    linkage.reserve(definition);
    nested(definition.body()).forEach(inner -> reserve(inner, linkage));
  }

  private static void compileNested(
      Source source,
      Definition definition,
      FunctionScope outer,
      Builtins<?> builtins,
      Linkage linkage) {
    FunctionScope scope = outer.nested(definition);
    StatementCompiler compiler =
        new StatementCompiler(
            new FunctionContext(source, scope, linkage, scope.locals()), builtins);
    compiler.defaults(definition.parameters());
    compiler.statements(definition.body());
    linkage.define(linkage.function(definition), compiler.finish(definition));
    nested(definition.body())
        .forEach(inner -> compileNested(source, inner, scope, builtins, linkage));
  }

  /** The definitions that stand anywhere in {@code body}, not counting those inside them. */
  private static List<Definition> nested(List<Statement> body) {
    return body.stream()
        .flatMap(
            statement ->
                switch (statement) {
                  case Definition definition -> Stream.of(definition);
                  case Statement.While loop -> nested(loop.body()).stream();
                  case Statement.If choice ->
                      Stream.concat(
                          choice.branches().stream().flatMap(b -> nested(b.body()).stream()),
                          choice.otherwise().stream().flatMap(b -> nested(b).stream()));
                  default -> Stream.<Definition>empty();
                })
        .toList();
  }
}
