package org.pendant.testing.source;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Parameter;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Binary;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.IntLiteral;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Expression.StringLiteral;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.Evaluate;
import org.pendant.script.function.Builtins;
import org.pendant.testing.builtin.AnsweringBuiltins;

/**
 * Answering functions of a test file: those that answer in place of others. A thread is made that
 * waits for their calls; each call is answered in a thread of its own, so that one that waits holds
 * up no other.
 */
final class AnsweringFunctions {
  private static final String DISPATCHER = "$answering";
  private static final String ANSWERER = "$answer_one";
  private static final String CALL = "$call";
  private static final String COUNT = "$count";

  private final List<AnsweringFunction> all = new ArrayList<>();
  private final Map<String, Definition> definitions = new HashMap<>();

  /** Is told what is wrong, and where. */
  @FunctionalInterface
  interface Problems {
    void report(SourceRange range, String message);
  }

  /**
   * Those of a file.
   *
   * @param own its statements
   */
  AnsweringFunctions(List<Statement> own) {
    SyntaxWalk.all(
        own,
        each -> {
          if (each instanceof Call call) {
            AnsweringFunction.of(call).ifPresent(all::add);
          }
        });
  }

  /** The names of functions that they answer for. */
  List<String> mocked() {
    return all.stream().filter(each -> !each.remote()).map(AnsweringFunction::function).toList();
  }

  /**
   * Takes the functions that there are, and reports what cannot answer.
   *
   * @param whole all statements of the program that the file becomes
   */
  void check(List<Statement> whole, Builtins<ControlBox> builtins, Problems problems) {
    Map<String, Definition> everywhere = new HashMap<>();
    Definitions.each(whole, each -> everywhere.putIfAbsent(each.name(), each));
    for (Statement each : whole) {
      if (each instanceof Definition definition
          && definition.kind() == Statement.DefinitionKind.FUNCTION) {
        definitions.putIfAbsent(definition.name(), definition);
      }
    }
    for (AnsweringFunction each : all) {
      Definition by = definitions.get(each.by());
      if (by == null) {
        problems.report(each.byRange(), SourceTexts.text("noFunction", each.by()));
        continue;
      }
      if (!each.remote()) {
        Optional.ofNullable(everywhere.get(each.function()))
            .map(AnsweringFunctions::arguments)
            .or(() -> arguments(builtins, each.function()))
            .ifPresent(given -> check(each, arguments(by), given, problems));
      }
    }
  }

  /** How many arguments a function takes. */
  private record Arguments(int least, int most) {
    /** What is said of the function that has these, besides what one takes that answers for it. */
    String besides(String taken, String function) {
      return least == most
          ? SourceTexts.text("otherArguments", taken, function, least)
          : SourceTexts.text("otherArgumentRange", taken, function, least, most);
    }
  }

  private static Arguments arguments(Definition definition) {
    int needed =
        (int)
            definition.parameters().stream().filter(each -> each.defaultValue().isEmpty()).count();
    return new Arguments(needed, definition.parameters().size());
  }

  private static Optional<Arguments> arguments(Builtins<ControlBox> builtins, String name) {
    return builtins
        .find(name)
        .map(
            each -> {
              List<Parameter> parameters = each.signature().parameters();
              int needed = (int) parameters.stream().filter(Parameter::required).count();
              return new Arguments(needed, parameters.size());
            });
  }

  private static void check(
      AnsweringFunction which, Arguments takes, Arguments given, Problems problems) {
    if (takes.least() > given.most() || takes.most() < given.least()) {
      problems.report(
          which.byRange(),
          given.besides(
              AnsweringBuiltins.mismatch(which.by(), takes.least(), takes.most()),
              which.function()));
    }
  }

  /** Adds the threads, and the statement that starts one; nothing where no function answers. */
  void into(List<Statement> functions, List<Statement> first) {
    if (all.isEmpty()) {
      return;
    }
    SourceRange at = all.getFirst().range();
    functions.add(answerer(at));
    Statement loop =
        new Statement.While(
            new Expression.BoolLiteral(true, at),
            List.of(
                new Evaluate(call(AnsweringBuiltins.AWAIT, at), at),
                new Evaluate(new Expression.Run(ANSWERER, at, List.of(), at), at)),
            at);
    functions.add(thread(DISPATCHER, List.of(loop), at));
    first.add(new Evaluate(new Expression.Run(DISPATCHER, at, List.of(), at), at));
  }

  private static Definition thread(String name, List<Statement> body, SourceRange at) {
    return new Definition(Statement.DefinitionKind.THREAD, name, at, List.of(), body, at, at);
  }

  private Definition answerer(SourceRange at) {
    Set<String> done = new HashSet<>();
    List<Statement.Branch> branches = new ArrayList<>();
    for (AnsweringFunction each : all) {
      if (definitions.containsKey(each.by()) && done.add(each.function() + "\n" + each.by())) {
        branches.add(branch(each));
      }
    }
    List<Statement> body = new ArrayList<>();
    body.add(local(CALL, call(AnsweringBuiltins.TAKE, at), at));
    if (!branches.isEmpty()) {
      body.add(new Statement.If(branches, Optional.empty(), at));
    }
    return thread(ANSWERER, body, at);
  }

  /** Answers where the call is for this function; whatever goes wrong does so at its place. */
  private Statement.Branch branch(AnsweringFunction which) {
    SourceRange at = which.range();
    Definition by = definitions.get(which.by());
    Arguments takes = arguments(by);
    List<Statement> body = new ArrayList<>();
    body.add(
        local(
            COUNT,
            call(
                AnsweringBuiltins.COUNT,
                at,
                new Name(CALL, at),
                new IntLiteral(takes.least(), at),
                new IntLiteral(takes.most(), at)),
            at));
    List<Statement.Branch> counts = new ArrayList<>();
    for (int count = takes.least(); count <= takes.most(); count++) {
      counts.add(
          new Statement.Branch(
              new Binary(BinaryOperator.EQUAL, new Name(COUNT, at), new IntLiteral(count, at), at),
              answer(by, count, at),
              at));
    }
    body.add(new Statement.If(counts, Optional.empty(), at));
    Expression isFor =
        call(
            AnsweringBuiltins.IS_FOR,
            at,
            new Name(CALL, at),
            new StringLiteral(which.function(), at),
            new StringLiteral(which.by(), at));
    return new Statement.Branch(isFor, body, at);
  }

  private static List<Statement> answer(Definition by, int count, SourceRange at) {
    List<Expression> arguments = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      arguments.add(
          call(AnsweringBuiltins.ARGUMENT, at, new Name(CALL, at), new IntLiteral(i, at)));
    }
    Expression called = Expectations.call(by.name(), at, arguments);
    if (returns(by.body())) {
      return List.of(
          new Evaluate(call(AnsweringBuiltins.ANSWER, at, new Name(CALL, at), called), at));
    }
    return List.of(
        new Evaluate(called, at),
        new Evaluate(call(AnsweringBuiltins.ANSWER, at, new Name(CALL, at)), at));
  }

  /** Whether a function returns a value anywhere. */
  private static boolean returns(List<Statement> body) {
    return body.stream()
        .anyMatch(
            each ->
                switch (each) {
                  case Statement.Return back -> back.value().isPresent();
                  case Statement.While loop -> returns(loop.body());
                  case Statement.If choice ->
                      choice.branches().stream().anyMatch(branch -> returns(branch.body()))
                          || returns(choice.otherwise().orElse(List.of()));
                  default -> false;
                });
  }

  private static Statement local(String name, Expression value, SourceRange at) {
    return new Statement.Assign(Statement.Qualifier.LOCAL, new Name(name, at), value, at);
  }

  private static Expression call(String function, SourceRange at, Expression... arguments) {
    return Expectations.call(function, at, List.of(arguments));
  }
}
