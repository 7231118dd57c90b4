package org.pendant.script.function;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;

/**
 * Builtins: every built-in function and method, each declared once beside its code; interpreter,
 * checker, completion and documentation read this and own no other list.
 *
 * @param <H> what programs run on
 */
public final class Builtins<H extends Host> implements Catalogue {
  private final Map<String, Builtin<H>> functions = new LinkedHashMap<>();
  private final Map<Type, Map<String, Builtin<H>>> methods = new EnumMap<>(Type.class);
  private final Map<Type, AnyMethodCode<H>> anyMethods = new EnumMap<>(Type.class);
  private final Map<String, String> absent = new HashMap<>();

  /** Starts the declaration of function {@code name}; {@link Declaration#does} ends it. */
  public Declaration<H> declare(String name) {
    return new Declaration<>(this, Optional.empty(), name);
  }

  /**
   * Starts the declaration of a method of lists, matrices or structs. The receiver is argument 0 of
   * the call, the parameters follow.
   */
  public Declaration<H> declareMethod(Type receiver, String name) {
    return new Declaration<>(this, Optional.of(receiver), name);
  }

  /** Has {@code code} do every method of {@code receiver} that is not declared. */
  public void declareAnyMethod(Type receiver, AnyMethodCode<H> code) {
    anyMethods.put(receiver, code);
  }

  /**
   * The same catalogue in which some functions do something else.
   *
   * @param others what they do, by their names; names of no function are left aside
   */
  public Builtins<H> replacing(Map<String, BuiltinCode<H>> others) {
    Builtins<H> replaced = new Builtins<>();
    functions.forEach(
        (name, builtin) ->
            replaced.functions.put(
                name, others.containsKey(name) ? builtin.doing(others.get(name)) : builtin));
    replaced.methods.putAll(methods);
    replaced.anyMethods.putAll(anyMethods);
    return replaced;
  }

  /**
   * The same catalogue without some functions.
   *
   * @param why there are none of them, by their names
   */
  public Builtins<H> without(Map<String, String> why) {
    Builtins<H> fewer = replacing(Map.of());
    fewer.functions.keySet().removeAll(why.keySet());
    fewer.absent.putAll(absent);
    fewer.absent.putAll(why);
    return fewer;
  }

  @Override
  public Optional<String> absence(String name) {
    return Optional.ofNullable(absent.get(name));
  }

  void add(Builtin<H> builtin) {
    Map<String, Builtin<H>> table =
        builtin
            .signature()
            .receiver()
            .map(type -> methods.computeIfAbsent(type, key -> new LinkedHashMap<>()))
            .orElse(functions);
    if (table.putIfAbsent(builtin.name(), builtin) != null) {
      throw new IllegalStateException(builtin.name() + " is declared twice");
    }
  }

  public Optional<Builtin<H>> find(String name) {
    return Optional.ofNullable(functions.get(name));
  }

  public Optional<Builtin<H>> findMethod(Type receiver, String name) {
    return Optional.ofNullable(methods.getOrDefault(receiver, Map.of()).get(name));
  }

  /** Whether a method of that name may change what it is called for. */
  public boolean changesReceiver(String method) {
    return methods.values().stream()
        .map(table -> table.get(method))
        .anyMatch(builtin -> builtin != null && builtin.changesReceiver());
  }

  /** The method {@code name}, declared or not, as a call with {@code count} arguments sees it. */
  public Optional<Builtin<H>> findMethod(Type receiver, String name, int count) {
    return findMethod(receiver, name).or(() -> findAnyMethod(receiver, name, count));
  }

  /** The undeclared method {@code name} with {@code count} arguments. */
  private Optional<Builtin<H>> findAnyMethod(Type receiver, String name, int count) {
    return Optional.ofNullable(anyMethods.get(receiver))
        .map(
            code -> {
              Declaration<H> declaration = new Declaration<>(this, Optional.of(receiver), name);
              for (int i = 1; i <= count; i++) {
                declaration.needs("argument " + i, Type.ANY);
              }
              return declaration.undeclared(call -> code.run(call, name, count));
            });
  }

  @Override
  public Optional<Signature> function(String name) {
    return find(name).map(Builtin::signature);
  }

  @Override
  public Optional<Signature> method(Type receiver, String name) {
    return findMethod(receiver, name).map(Builtin::signature);
  }

  @Override
  public Collection<Signature> all() {
    List<Signature> all =
        new ArrayList<>(functions.values().stream().map(Builtin::signature).toList());
    methods.values().forEach(table -> table.values().forEach(m -> all.add(m.signature())));
    return all;
  }
}
