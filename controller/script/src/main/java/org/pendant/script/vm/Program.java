package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.pendant.language.check.Scopes;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.coverage.CoverageMap;
import org.pendant.script.function.Builtin;
import org.pendant.script.value.Value;

/**
 * Compiled program, ready to start any number of times. Immutable.
 *
 * <p>Its static slots hold constants and global variables, mixed in the order of their first use.
 */
public final class Program {
  private final String name;
  private final Source source;
  private final boolean secondary;
  private final Scopes scopes;
  private final IdentityHashMap<Definition, Integer> functionNumbers;
  private final OptionalInt mainFunction;
  private final Tables tables;
  private final List<ProgramLabel> labels;
  private final Optional<CoverageSlots> coverage;
  private final Optional<CoverageMap> coverageMap;

  /**
   * What instructions refer to by number.
   *
   * @param functions the main level first
   * @param staticNames the global variable in each static slot; empty text for a constant
   * @param staticValues the constant in each static slot; NONE for a variable
   * @param names methods and members
   * @param nameLists the member names of each struct literal
   */
  record Tables(
      List<ScriptFunction> functions,
      List<String> staticNames,
      List<Value> staticValues,
      List<Builtin<?>> builtins,
      List<String> names,
      List<List<String>> nameLists) {
    Tables {
      functions = List.copyOf(functions);
      staticNames = List.copyOf(staticNames);
      staticValues = List.copyOf(staticValues);
      builtins = List.copyOf(builtins);
      names = List.copyOf(names);
      nameLists = List.copyOf(nameLists);
    }

    /** The constant in static slot {@code slot}; empty for a variable and for unknown slots. */
    Optional<Value> constant(int slot) {
      return slot < staticNames.size() && staticNames.get(slot).isEmpty()
          ? Optional.of(staticValues.get(slot))
          : Optional.empty();
    }
  }

  Program(
      String name,
      Source source,
      boolean secondary,
      Scopes scopes,
      IdentityHashMap<Definition, Integer> functionNumbers,
      OptionalInt mainFunction,
      Tables tables,
      List<ProgramLabel> labels,
      Optional<CoverageSlots> coverage) {
    this.name = name;
    this.source = source;
    this.secondary = secondary;
    this.scopes = scopes;
    this.functionNumbers = functionNumbers;
    this.mainFunction = mainFunction;
    this.tables = tables;
    this.labels = List.copyOf(labels);
    this.coverage = coverage;
    coverageMap = coverage.map(slots -> slots.map(source));
  }

  /** The name on its {@code def} or {@code sec} line, or the file's for a fragment. */
  public String name() {
    return name;
  }

  public Source source() {
    return source;
  }

  /** Whether it is a secondary program (manual 12). */
  public boolean secondary() {
    return secondary;
  }

  /** The labels in it that have a number, by their lines. */
  public List<ProgramLabel> labels() {
    return labels;
  }

  /** The places that its runs mark when they reach them; empty without coverage. */
  public Optional<CoverageMap> coverageMap() {
    return coverageMap;
  }

  /** The coverage that the marks of a run tell; empty without coverage. */
  Optional<Coverage> coverage(byte[] marks) {
    return coverage.map(
        slots -> {
          byte[] all = marks.clone();
          slots.complete(all);
          return new Coverage(coverageMap.orElseThrow(), all);
        });
  }

  /**
   * The first offset of the statement that a breakpoint on {@code line} means: the first that
   * begins there, or on the nearest line after it where one does; empty after the last.
   *
   * @param line 1-based
   */
  public OptionalInt statementFrom(int line) {
    int best = Integer.MAX_VALUE;
    for (ScriptFunction function : tables.functions()) {
      StatementTable statements = function.statements();
      for (int i = 0; i < statements.size(); i++) {
        int start = statements.start(i);
        if (start < best && source.line(start) >= line) {
          best = start;
        }
      }
    }
    return best == Integer.MAX_VALUE ? OptionalInt.empty() : OptionalInt.of(best);
  }

  /**
   * The first offsets of the statements that call a built-in function themselves.
   *
   * @param functions names of those that are meant
   */
  public Set<Integer> statementsCalling(Set<String> functions) {
    Set<Integer> starts = new HashSet<>();
    for (ScriptFunction function : tables.functions()) {
      long[] words = function.instructions();
      for (int pc = 0; pc < words.length; pc++) {
        int statement = function.statements().around(pc);
        if (statement >= 0
            && Instruction.operation(words[pc]) == Op.CALL_BUILTIN
            && functions.contains(tables.builtins().get(Instruction.b(words[pc])).name())) {
          starts.add(function.statements().start(statement));
        }
      }
    }
    return starts;
  }

  /** The names of its global variables, in the order of their first assignment. */
  Set<String> globals() {
    return scopes.globals();
  }

  /**
   * The names of the variables that can be looked at while it runs: the global ones, and for a
   * fragment those of the function that its last statement calls.
   */
  public List<String> variables() {
    List<String> names = new ArrayList<>(scopes.globals());
    if (mainFunction.isPresent()) {
      names.addAll(tables.functions().get(mainFunction.getAsInt()).variables());
    }
    names.removeIf(String::isEmpty);
    return names;
  }

  /**
   * The number of the function in which a fragment spends its time, because its last statement
   * calls that; empty for any other program, whose own function is its main level.
   */
  OptionalInt mainFunction() {
    return mainFunction;
  }

  Scopes scopes() {
    return scopes;
  }

  /** The number of each function and thread, by identity. */
  IdentityHashMap<Definition, Integer> functionNumbers() {
    return functionNumbers;
  }

  Tables tables() {
    return tables;
  }
}
