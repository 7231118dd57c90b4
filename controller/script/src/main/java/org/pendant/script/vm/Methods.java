package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/**
 * Method lookup: finds methods by the kind of their receiver, which is known only when the call
 * runs.
 */
final class Methods {
  private final Builtins<?> builtins;
  private final Map<ValueKind, Map<String, Builtin<?>>> known = new EnumMap<>(ValueKind.class);
  private final Map<Type, Map<String, Builtin<?>>> ofHandles = new EnumMap<>(Type.class);

  Methods(Builtins<?> builtins) {
    this.builtins = builtins;
  }

  /** What a method call is compiled to: the method's name and how many arguments it passes. */
  static String key(String name, int argumentCount) {
    return name + "/" + argumentCount;
  }

  /**
   * The method that {@code key} means for a receiver of {@code kind}.
   *
   * @throws ScriptError when there is none, or it takes another number of arguments
   */
  Builtin<?> find(String key, ValueKind kind) throws ScriptError {
    Map<String, Builtin<?>> table = known.computeIfAbsent(kind, k -> new HashMap<>());
    Builtin<?> found = table.get(key);
    if (found == null) {
      found =
          look(key, receiver(kind).orElseThrow(() -> unknown(kind.text(), name(key))), kind.text());
      table.put(key, found);
    }
    return found;
  }

  /** As {@link #find(String, ValueKind)}, for a receiver that is a handle of {@code type}. */
  Builtin<?> find(String key, Type type) throws ScriptError {
    Map<String, Builtin<?>> table = ofHandles.computeIfAbsent(type, t -> new HashMap<>());
    Builtin<?> found = table.get(key);
    if (found == null) {
      found = look(key, type, type.text());
      table.put(key, found);
    }
    return found;
  }

  /** How many arguments the call passes that was compiled to {@code key}. */
  static int argumentCount(String key) {
    return Integer.parseInt(key.substring(key.lastIndexOf('/') + 1));
  }

  private static String name(String key) {
    return key.substring(0, key.lastIndexOf('/'));
  }

  private Builtin<?> look(String key, Type type, String receiver) throws ScriptError {
    String name = name(key);
    int count = argumentCount(key);
    Builtin<?> method =
        builtins.findMethod(type, name, count).orElseThrow(() -> unknown(receiver, name));
    int most = method.signature().parameters().size();
    int least = method.signature().requiredCount();
    if (count < least || count > most) {
      throw new ScriptError(
          "argument-count",
          least < most
              ? text("takesCounts", method.signature().head(), least, most, count)
              : text("takesCount", method.signature().head(), most, count));
    }
    return count < most ? method.withFirst(count) : method;
  }

  private static ScriptError unknown(String receiver, String name) {
    String article = receiver.startsWith("e") ? "an " : "a ";
    return new ScriptError("unknown-method", text("noMethod", article + receiver, name));
  }

  private static Optional<Type> receiver(ValueKind kind) {
    return switch (kind) {
      case LIST -> Optional.of(Type.LIST);
      case MATRIX -> Optional.of(Type.MATRIX);
      case STRUCT -> Optional.of(Type.STRUCT);
      default -> Optional.empty();
    };
  }
}
