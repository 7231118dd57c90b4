package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.script.function.Builtin;

/**
 * Linkage: numbers everything that instructions refer to, while a program or a line is compiled.
 */
final class Linkage {
  private final StaticSlots statics;
  private final List<ScriptFunction> functions;
  private final IdentityHashMap<Definition, Integer> definitions = new IdentityHashMap<>();
  private final List<Builtin<?>> builtins;
  private final Map<String, Integer> builtinNumbers = new HashMap<>();
  private final List<String> names;
  private final Map<String, Integer> nameNumbers = new HashMap<>();
  private final List<List<String>> nameLists;
  private final List<ProgramLabel> labels = new ArrayList<>();
  private final Optional<CoverageSlots> coverage;

  /**
   * Nothing yet.
   *
   * @param coverage what gives marks; empty without coverage
   */
  Linkage(Optional<CoverageSlots> coverage) {
    this(
        new StaticSlots(),
        new ArrayList<>(),
        new ArrayList<>(),
        new ArrayList<>(),
        new ArrayList<>(),
        coverage);
  }

  private Linkage(
      StaticSlots statics,
      List<ScriptFunction> functions,
      List<Builtin<?>> builtins,
      List<String> names,
      List<List<String>> nameLists,
      Optional<CoverageSlots> coverage) {
    this.statics = statics;
    this.functions = functions;
    this.builtins = builtins;
    this.names = names;
    this.nameLists = nameLists;
    this.coverage = coverage;
    for (int i = 0; i < builtins.size(); i++) {
      builtinNumbers.put(builtins.get(i).name(), i);
    }
    for (int i = 0; i < names.size(); i++) {
      nameNumbers.put(names.get(i), i);
    }
  }

  /** Continues from a linked program; {@code statics} places what is new. */
  static Linkage after(
      Program.Tables tables,
      IdentityHashMap<Definition, Integer> definitions,
      StaticSlots statics) {
    Linkage linkage =
        new Linkage(
            statics,
            new ArrayList<>(tables.functions()),
            new ArrayList<>(tables.builtins()),
            new ArrayList<>(tables.names()),
            new ArrayList<>(tables.nameLists()),
            Optional.empty());
    linkage.definitions.putAll(definitions);
    return linkage;
  }

  /** What gives the places of functions their marks; empty without coverage. */
  Optional<CoverageSlots> coverage() {
    return coverage;
  }

  StaticSlots statics() {
    return statics;
  }

  /** Reserves a number for a function that is compiled later. */
  int reserve() {
    functions.add(null);
    return functions.size() - 1;
  }

  void reserve(Definition definition) {
    definitions.put(definition, reserve());
  }

  int function(Definition definition) {
    return definitions.get(definition);
  }

  IdentityHashMap<Definition, Integer> definitions() {
    return definitions;
  }

  void define(int number, ScriptFunction function) {
    functions.set(number, function);
  }

  int builtin(Builtin<?> builtin) {
    return builtinNumbers.computeIfAbsent(
        builtin.name(),
        name -> {
          builtins.add(builtin);
          return builtins.size() - 1;
        });
  }

  int name(String name) {
    return nameNumbers.computeIfAbsent(
        name,
        key -> {
          names.add(key);
          return names.size() - 1;
        });
  }

  int nameList(List<String> list) {
    int known = nameLists.indexOf(list);
    if (known >= 0) {
      return known;
    }
    nameLists.add(List.copyOf(list));
    return nameLists.size() - 1;
  }

  void label(ProgramLabel label) {
    labels.add(label);
  }

  /** The labels by their lines. */
  List<ProgramLabel> labels() {
    labels.sort((a, b) -> Integer.compare(a.line(), b.line()));
    return labels;
  }

  Program.Tables tables() {
    return new Program.Tables(
        functions, statics.names(), statics.values(), builtins, names, nameLists);
  }
}
