package org.pendant.desktop.program.form;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Kept settings: what the node had before its kind was changed, so that changing the kind back
 * loses nothing; until another node is selected.
 */
final class Kept {
  private final Map<String, Object> values = new HashMap<>();

  /** Keeps a value as the newest of its class. */
  void keep(Object value) {
    keep(value.getClass().getName(), value);
  }

  /** Keeps a value under a name. */
  void keep(String name, Object value) {
    values.put(name, value);
  }

  /** The newest value of a class, otherwise {@code first}. */
  <T> T recall(Class<T> type, T first) {
    return recall(type.getName(), type).orElse(first);
  }

  /** The newest value of a class. */
  <T> Optional<T> recall(Class<T> type) {
    return recall(type.getName(), type);
  }

  /** The newest value of a name. */
  <T> Optional<T> recall(String name, Class<T> type) {
    return Optional.ofNullable(values.get(name)).filter(type::isInstance).map(type::cast);
  }

  void clear() {
    values.clear();
  }
}
