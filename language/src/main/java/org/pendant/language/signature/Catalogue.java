package org.pendant.language.signature;

import java.util.Collection;
import java.util.Optional;

/** Catalogue of every function and method that a program may call without defining it. */
public interface Catalogue {

  /** The function called {@code name}. */
  Optional<Signature> function(String name);

  /** The method {@code name} of values of {@code receiver} (list, matrix, struct). */
  Optional<Signature> method(Type receiver, String name);

  /**
   * The function to write in place of {@code name}: the one that succeeds it when it is deprecated
   * and both take as many arguments, else itself.
   */
  default String current(String name) {
    return function(name)
        .filter(old -> !old.deprecated().isEmpty())
        .flatMap(
            old ->
                function(old.deprecated())
                    .filter(each -> each.requiredCount() == old.requiredCount())
                    .filter(each -> each.parameters().size() == old.parameters().size()))
        .map(Signature::name)
        .orElse(name);
  }

  /**
   * Why there is no function {@code name} here although other programs may call it; empty where
   * there is nothing to say.
   */
  default Optional<String> absence(String name) {
    return Optional.empty();
  }

  /** Functions and methods, in the order of their declaration. */
  Collection<Signature> all();
}
