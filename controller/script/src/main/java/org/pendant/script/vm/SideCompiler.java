package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.HashMap;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.language.check.Binding;
import org.pendant.language.check.Checker;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Qualifier;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.ScriptError;

/** Side compiler: compiles expressions and assignments for a place in a running program. */
final class SideCompiler {
  /** Constants that one of them may have. */
  private static final int MAX_CONSTANTS = 4096;

  /** What an expression is assigned to while it is parsed and checked. */
  private static final String RESULT = "the_value_of_this_expression";

  private final Builtins<?> builtins;
  private final Interpreter interpreter;

  SideCompiler(Builtins<?> builtins, Interpreter interpreter) {
    this.builtins = builtins;
    this.interpreter = interpreter;
  }

  /**
   * An expression.
   *
   * @param function where its names mean what they mean at {@code offset}
   */
  SideCode expression(ProgramRun run, ScriptFunction function, int offset, String text)
      throws ScriptError {
    if (text.isBlank()) {
      throw new ScriptError("not-an-expression", text("noExpression"));
    }
    Source source = Source.of("expression", RESULT + " = " + text);
    Assign parsed = parse(source, function, text("notExpression", text));
    if (!(parsed.target() instanceof Expression.Name)) {
      throw new ScriptError("not-an-expression", text("notExpression", text));
    }
    return compile(run, function, offset, source, Optional.empty(), parsed);
  }

  /** An assignment to a variable that is there, or to a part of one. */
  SideCode assignment(
      ProgramRun run, ScriptFunction function, int offset, String target, String value)
      throws ScriptError {
    Source source = Source.of("expression", target + " = " + value);
    Assign parsed = parse(source, function, text("notAssignment", source.text()));
    if (parsed.qualifier() != Qualifier.FREE) {
      throw new ScriptError("not-a-variable", text("notVariable", target));
    }
    return compile(run, function, offset, source, Optional.of(target), parsed);
  }

  private Assign parse(Source source, ScriptFunction function, String otherwise)
      throws ScriptError {
    ParseResult parsed = ScriptParser.parseLine(source);
    refuseErrors(parsed.diagnostics());
    List<Statement> statements = parsed.script().statements();
    if (statements.size() != 1 || !(statements.getFirst() instanceof Assign assign)) {
      throw new ScriptError("not-an-expression", otherwise);
    }
    refuseErrors(Checker.checkLine(parsed.script(), function.scope(), builtins));
    return assign;
  }

  private static void refuseErrors(List<Diagnostic> diagnostics) throws ScriptError {
    for (Diagnostic diagnostic : diagnostics) {
      if (diagnostic.isError()) {
        throw new ScriptError(diagnostic.code(), diagnostic.message());
      }
    }
  }

  /**
   * @param target the text of what is assigned; empty for an expression
   */
  private SideCode compile(
      ProgramRun run,
      ScriptFunction function,
      int offset,
      Source source,
      Optional<String> target,
      Assign parsed)
      throws ScriptError {
    int first = interpreter.firstFreeStatic();
    StaticSlots statics =
        new StaticSlots(first, first + MAX_CONSTANTS - 1, new HashMap<>(run.globalSlots()));
    Linkage linkage = Linkage.after(run.tables(), interpreter.functionNumbers(), statics);
    FunctionContext context =
        new FunctionContext(
            source, function.scope(), linkage, function.variables(), OptionalInt.of(offset));
    try {
      int result =
          target.isPresent()
              ? assign(context, parsed, target.get())
              : evaluate(context, parsed.value());
      context.code().emit(Op.RETURN_NONE, 0, 0, 0);
      ScriptFunction code = context.function("expression", 0);
      boolean changing = SideEffects.changes(code, linkage.tables());
      return new SideCode(code, linkage.tables(), statics, changing || target.isPresent(), result);
    } catch (ProgramTooLarge e) {
      throw new ScriptError("program-too-large", e.getMessage());
    }
  }

  private int evaluate(FunctionContext context, Expression expression) {
    int result = Instruction.local(context.temporary());
    int operand = new ExpressionCompiler(context, builtins).operand(expression);
    context.code().emit(Op.COPY, result, operand, 0);
    return result;
  }

  private int assign(FunctionContext context, Assign parsed, String target) throws ScriptError {
    Binding variable = context.target(parsed);
    if (!context.knows(variable)) {
      throw new ScriptError("unknown-variable", text("noVariableHere", target));
    }
    ExpressionCompiler expressions = new ExpressionCompiler(context, builtins);
    new AssignmentCompiler(context, expressions).assign(parsed);
    return context.variable(variable);
  }
}
