package org.pendant.controller.machine;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.call.Builtin;
import org.pendant.controller.call.Builtins;
import org.pendant.controller.value.Kind;
import org.pendant.controller.value.ScriptError;
import org.pendant.language.signature.Type;

/** Finds methods by the kind of their receiver, which is known only when the call runs. */
final class Methods {
  private final Builtins builtins;
  private final Map<Kind, Map<String, Builtin>> known = new EnumMap<>(Kind.class);

  Methods(Builtins builtins) {
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
  Builtin find(String key, Kind kind) throws ScriptError {
    Map<String, Builtin> table = known.computeIfAbsent(kind, k -> new HashMap<>());
    Builtin found = table.get(key);
    if (found == null) {
      found = look(key, kind);
      table.put(key, found);
    }
    return found;
  }

  private Builtin look(String key, Kind kind) throws ScriptError {
    String name = key.substring(0, key.lastIndexOf('/'));
    int count = Integer.parseInt(key.substring(name.length() + 1));
    Builtin method =
        receiver(kind)
            .flatMap(type -> builtins.findMethod(type, name))
            .orElseThrow(
                () ->
                    new ScriptError(
                        "unknown-method", "a " + kind.text() + " has no method " + name));
    int expected = method.signature().parameters().size();
    if (count != expected) {
      throw new ScriptError(
          "argument-count",
          method.signature().head() + " takes " + expected + " arguments, not " + count);
    }
    return method;
  }

  private static Optional<Type> receiver(Kind kind) {
    return switch (kind) {
      case LIST -> Optional.of(Type.LIST);
      case MATRIX -> Optional.of(Type.MATRIX);
      case STRUCT -> Optional.of(Type.STRUCT);
      default -> Optional.empty();
    };
  }
}
