package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.Registers;
import org.pendant.script.value.Value;

/** Line links: what interpreted lines add to a program: links one after the other into it. */
final class LineLinks {
  private final StaticSlots statics;
  private final IdentityHashMap<Definition, Integer> functionNumbers;
  private FunctionScope scope;
  private Program.Tables tables;

  /** The variables of the lines in the order of their slots, which come after the function's. */
  private List<String> variables;

  /** How many of them have their slots; the others' values are not in registers. */
  private int placed;

  /** The values of variables without a slot, as they were when they last had one. */
  private final Map<String, Value> values;

  /**
   * No line yet.
   *
   * @param scope that the first line stands in
   * @param statics where constants go
   */
  LineLinks(
      FunctionScope scope,
      Program.Tables tables,
      IdentityHashMap<Definition, Integer> functionNumbers,
      StaticSlots statics) {
    this(scope, tables, functionNumbers, statics, List.of(), new HashMap<>());
  }

  private LineLinks(
      FunctionScope scope,
      Program.Tables tables,
      IdentityHashMap<Definition, Integer> functionNumbers,
      StaticSlots statics,
      List<String> variables,
      Map<String, Value> values) {
    this.scope = scope;
    this.tables = tables;
    this.functionNumbers = functionNumbers;
    this.statics = statics;
    this.variables = variables;
    this.values = values;
  }

  /** The same lines, to which others can be added on the side. */
  LineLinks copy() {
    LineLinks copy = in(scope, variables);
    copy.placed = placed;
    return copy;
  }

  /** The same lines for others that stand in a function; no variable has its slot. */
  LineLinks in(FunctionScope function) {
    FunctionScope extended = function.with(scope);
    return in(extended, added(extended, function));
  }

  private LineLinks in(FunctionScope where, List<String> known) {
    return new LineLinks(
        where,
        tables,
        new IdentityHashMap<>(functionNumbers),
        statics.copy(),
        known,
        new HashMap<>(values));
  }

  /** What the next line stands in. */
  FunctionScope scope() {
    return scope;
  }

  /** Takes the variables out of their slots, which the function that continues needs itself. */
  void takeValues(Registers registers, ScriptThread thread) {
    int first = thread.base() + thread.functions[thread.depth - 1].slotCount();
    for (int i = 0; i < placed; i++) {
      if (registers.assigned(first + i)) {
        values.put(variables.get(i), registers.value(first + i));
      }
    }
    placed = 0;
    thread.lineSlots = 0;
  }

  /** Gives its own variables the values that they have in {@code newer}. */
  void takeValues(LineLinks newer) {
    for (String variable : variables) {
      if (newer.values.containsKey(variable)) {
        values.put(variable, newer.values.get(variable));
      }
    }
  }

  /** The numbers of the functions that the program has by now. */
  IdentityHashMap<Definition, Integer> functionNumbers() {
    return functionNumbers;
  }

  /** How many global variables and constants the lines have. */
  int statics() {
    return statics.names().size();
  }

  /**
   * Links a line and lets a thread execute it next.
   *
   * @param as what becomes of the tables that the run then has
   */
  void link(
      ProgramRun run,
      ScriptThread thread,
      Script line,
      Builtins<?> builtins,
      UnaryOperator<Program.Tables> as) {
    ScriptFunction base = thread.functions[thread.depth - 1];
    FunctionScope extended = scope.extendedBy(line.statements());
    int known = statics.names().size();
    Linkage linkage = Linkage.after(tables, functionNumbers, statics);
    List<String> slots = new ArrayList<>(base.variables());
    while (slots.size() < base.slotCount()) {
      // the call of interpreter_mode stands among its temporaries
      slots.add("");
    }
    List<String> added = added(extended, base.scope());
    slots.addAll(added);
    ScriptFunction compiled =
        Compiler.compileLine(line.source(), line.statements(), extended, slots, builtins, linkage);
    scope = extended;
    variables = added;
    tables = linkage.tables();
    functionNumbers.putAll(linkage.definitions());
    run.link(as.apply(tables));
    run.fill(statics, known);
    int before = base.slotCount() + placed;
    run.pushLine(thread, compiled, before);
    for (int i = before; i < slots.size(); i++) {
      Value value = values.get(slots.get(i));
      if (value != null) {
        run.registers().set(thread.base() + i, value.copy());
      }
    }
    placed = added.size();
  }

  /** The variables that lines have added to those of the function that they stand in. */
  private static List<String> added(FunctionScope lines, FunctionScope function) {
    List<String> locals = lines.locals();
    return List.copyOf(locals.subList(function.locals().size(), locals.size()));
  }
}
