package org.pendant.controller.machine;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.function.UnaryOperator;
import org.pendant.controller.call.Builtins;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement.Definition;

/** What interpreted lines add to a program: links one after the other into it. */
final class LineLinks {
  private final StaticSlots statics;
  private final IdentityHashMap<Definition, Integer> functionNumbers;
  private FunctionScope scope;
  private Program.Tables tables;

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
    this.scope = scope;
    this.tables = tables;
    this.functionNumbers = functionNumbers;
    this.statics = statics;
  }

  /** The same lines, to which others can be added on the side. */
  LineLinks copy() {
    return new LineLinks(scope, tables, new IdentityHashMap<>(functionNumbers), statics.copy());
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
      Builtins builtins,
      UnaryOperator<Program.Tables> as) {
    ScriptFunction base = thread.functions[thread.depth - 1];
    FunctionScope extended = scope.extendedBy(line.statements());
    int known = statics.names().size();
    Linkage linkage = Linkage.after(tables, functionNumbers, statics);
    ScriptFunction compiled =
        Compiler.compileLine(
            line.source(),
            line.statements(),
            extended,
            variables(base, extended),
            builtins,
            linkage);
    int before = variables(base, scope).size();
    scope = extended;
    tables = linkage.tables();
    functionNumbers.putAll(linkage.definitions());
    run.link(as.apply(tables));
    run.fill(statics, known);
    run.pushLine(thread, compiled, before);
  }

  /**
   * The slots of an interpreted line: those of the function it runs in, temporaries included since
   * the call of interpreter_mode stands among them, then the interpreter's own variables.
   */
  private static List<String> variables(ScriptFunction base, FunctionScope scope) {
    List<String> variables = new ArrayList<>(base.variables());
    while (variables.size() < base.slotCount()) {
      variables.add("");
    }
    List<String> locals = scope.locals();
    variables.addAll(locals.subList(base.scope().locals().size(), locals.size()));
    return variables;
  }
}
