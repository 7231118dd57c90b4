package org.pendant.kit.settings;

import java.util.Optional;

/** Settings that are remembered from one start to the next: text by name. */
public interface Settings {

  /** What was put under {@code name} last. */
  Optional<String> get(String name);

  /** Remembers {@code text}; it is written to disk soon. */
  void put(String name, String text);
}
