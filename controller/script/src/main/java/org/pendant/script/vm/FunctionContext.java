package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.language.check.Binding;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Index;
import org.pendant.language.syntax.Expression.Member;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Label;
import org.pendant.script.value.Value;

/**
 * Function context: one function while it is compiled: its code so far, what its names mean, and
 * its slots. Temporaries are taken and given back like a stack.
 */
final class FunctionContext {
  private final CodeBuilder code = new CodeBuilder();
  private final CoveragePoints coverage;
  private final Source source;
  private final FunctionScope scope;
  private final Linkage linkage;
  private final List<String> variables;
  private final OptionalInt place;
  private final Map<String, Integer> variableSlots = new HashMap<>();
  private int nextTemporary;
  private int slotCount;

  /**
   * @param variables parameters and local variables in the order of their slots
   */
  FunctionContext(Source source, FunctionScope scope, Linkage linkage, List<String> variables) {
    this(source, scope, linkage, variables, OptionalInt.empty());
  }

  /**
   * @param place the offset in the text of {@code scope} where names are to mean what they mean
   *     there; empty when the source itself is that text
   */
  FunctionContext(
      Source source,
      FunctionScope scope,
      Linkage linkage,
      List<String> variables,
      OptionalInt place) {
    this.place = place;
    this.source = source;
    this.scope = scope;
    this.linkage = linkage;
    this.variables = variables;
    coverage = new CoveragePoints(code, linkage.coverage());
    for (int i = 0; i < variables.size(); i++) {
      variableSlots.putIfAbsent(variables.get(i), i);
    }
    nextTemporary = variables.size();
    slotCount = nextTemporary;
  }

  CodeBuilder code() {
    return code;
  }

  CoveragePoints coverage() {
    return coverage;
  }

  ScriptFunction function(String name, int parameterCount) {
    return new ScriptFunction(
        name,
        source,
        code.code(),
        code.starts(),
        code.ends(),
        code.statements(),
        code.paid(0),
        coverage.unmarked(),
        parameterCount,
        variables,
        slotCount,
        scope);
  }

  Source source() {
    return source;
  }

  FunctionScope scope() {
    return scope;
  }

  Linkage linkage() {
    return linkage;
  }

  /** The text has a label; one without a number says nothing. */
  void label(Label label) {
    int line = source.line(label.range().start());
    label.number().ifPresent(number -> linkage.label(new ProgramLabel(line, number, label.text())));
  }

  /** The operand of a constant. */
  int constant(Value value) {
    return linkage.statics().constant(value);
  }

  int temporary() {
    return temporaries(1);
  }

  /** The index of the first of {@code count} consecutive temporaries. */
  int temporaries(int count) {
    int first = nextTemporary;
    nextTemporary += count;
    slotCount = Math.max(slotCount, nextTemporary);
    if (slotCount > Instruction.MAX_OPERAND) {
      throw new ProgramTooLarge(text("expressionTooLarge"));
    }
    return first;
  }

  /** How many slots are taken, to {@link #release} those taken later. */
  int mark() {
    return nextTemporary;
  }

  void release(int mark) {
    nextTemporary = mark;
  }

  Binding binding(Name name) {
    return scope.resolve(name.name(), place.orElse(name.range().start()));
  }

  /** The variable that {@code assign} sets, or whose element or member it sets. */
  Binding target(Assign assign) {
    return place.isEmpty() ? scope.target(assign) : binding(root(assign.target()));
  }

  /** The variable that {@code target} is or is a part of. */
  static Name root(Expression target) {
    return switch (target) {
      case Name name -> name;
      case Index index -> root(index.receiver());
      case Member member -> root(member.receiver());
      default -> throw new IllegalArgumentException(target + " is no variable");
    };
  }

  /** Whether there is such a variable. */
  boolean knows(Binding variable) {
    return switch (variable) {
      case Binding.Global global -> scope.globals().contains(global.name());
      case Binding.Local local -> variableSlots.containsKey(local.name());
    };
  }

  /** The operand of a name that nothing assigns: a global variable that never has a value. */
  private int unassigned(String name) {
    Optional<Boolean> truth = FunctionScope.truth(name);
    return truth.isPresent()
        ? constant(Value.of(truth.get().booleanValue()))
        : linkage.statics().global(name);
  }

  int variable(Binding binding) {
    return switch (binding) {
      case Binding.Global global -> linkage.statics().global(global.name());
      case Binding.Local local when !knows(local) -> unassigned(local.name());
      case Binding.Local local -> Instruction.local(variableSlots.get(local.name()));
    };
  }
}
